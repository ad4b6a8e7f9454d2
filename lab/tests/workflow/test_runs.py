"""The workflow runs, on stand-ins for what it builds: on this machine, and as Jobs of Kubernetes on a stand-in
for kubectl that runs them.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import json
import os
import subprocess
import sys

import pytest
from conftest import WORKFLOW, counted

KUBECTL = """#!{python}
import json, pathlib, subprocess, sys
jobs = pathlib.Path("{root}/jobs")
if sys.argv[1] == "create":
    job = json.load(sys.stdin)
    pod = job["spec"]["template"]["spec"]["containers"][0]
    name = f"{{job['metadata']['generateName']}}{{len(list(jobs.glob('*.json')))}}"
    (jobs / f"{{name}}.json").write_text(json.dumps(job))
    subprocess.Popen(["/bin/sh", "-c", f'"$@" > {{jobs}}/{{name}}.log 2>&1; echo $? > {{jobs}}/{{name}}.status', "-",
                      *pod["command"]], cwd=pod["workingDir"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                     start_new_session=True)
    print(f"job.batch/{{name}}")
else:
    status = jobs / f"{{sys.argv[2].split('/')[1]}}.status"
    ended = status.read_text() if status.exists() else ""
    print(json.dumps({{"status": {{"conditions": [{{"type": "Complete" if ended == "0\\n" else "Failed", "status": "True"}}]
                                 if ended else []}}}}))
"""


@pytest.fixture(name="kinds")
def _kinds(tree):
    with (tree.root / "lab" / "soak" / "traffic.csv").open(encoding="utf-8") as file:
        return len(list(csv.DictReader(file)))


@pytest.fixture(name="site")
def _site(tree, checkout):
    """A profile of a site: its volume is where the copy is."""
    checkout.copy("lab/workflow")
    text = tree.text("lab/workflow/profiles/kubernetes/config.yaml")
    tree.put({"site/config.yaml": text.replace("--volume /hwffd", f"--volume {tree.root}")})
    tree.put({"bin/kubectl": KUBECTL.format(python=sys.executable, root=tree.root)}, 0o755)
    (tree.root / "jobs").mkdir()
    return tree.root / "site"


def report(tree):
    return json.loads(tree.text("build/reports/soak.json"))


def test_parts_are_run_and_joined(tree, kinds):
    tree.buildable()
    status, output = tree.snakemake("local", work="soak", soak_seeds=2)
    assert status == 0, output[-3000:]
    joined = report(tree)
    assert len(joined["rows"]) == kinds and {(row["seeds"], row["results"]) for row in joined["rows"]} == {(2, 10)}
    assert json.loads(tree.text("build/lab/soak/next.json")) == 1032
    assert "--build lab -j" in tree.text("built") and tree.text("built").count("--target") == 1
    status, output = tree.snakemake("local", "--dry-run", work="soak", soak_seeds=2)
    assert status == 0 and counted(output)["soak"] == 2 and "seed 1048" in output


def test_parts_of_upsets_are_tops(tree):
    tree.buildable()
    status, output = tree.snakemake("local", work="upsets")
    assert status == 0, output[-3000:]
    joined = json.loads(tree.text("build/reports/upsets.json"))
    assert [row["flips"] for row in joined["rows"]] == 8 * [9604] and len(joined["cost"]) == 4
    assert "hwffd_upsets_programs" in tree.text("built")
    assert len(list((tree.root / "build" / "upsets").glob("*.csv"))) == 8


def test_a_part_that_cannot_be_measured_leaves_its_log(tree):
    tree.buildable()
    head, first, *_ = tree.text("lab/mutants/subjects.csv").splitlines()
    tree.put({"lab/mutants/subjects.csv": f"{head}\n{first}\n"})
    status, output = tree.snakemake("local", work="mutants")
    assert status == 1 and "Error in rule mutants" in output
    log, = (tree.root / "build" / "workflow" / "mutants").glob("*.log")
    assert "make -C lab mutants builds it" in log.read_text() and log.name.startswith(first.split(",", maxsplit=1)[0])
    assert not (tree.root / "build" / "reports").exists()


def test_a_fault_in_a_part_fails_the_report(tree, kinds):
    tree.buildable(fails=1016)
    status, output = tree.snakemake("local", work="soak", soak_seeds=2)
    assert status == 1 and "report_soak" in output
    assert report(tree)["faults"] == kinds
    assert tree.text("lab/soak/corpus.csv").count(",1016,Few.Lines") == kinds


def test_a_build_that_fails_ends_it(tree):
    tree.buildable()
    tree.put({"bin/cmake": "#!/bin/sh\necho no room; exit 1\n"}, 0o755)
    status, output = tree.snakemake("local", work="soak", soak_seeds=2)
    assert status == 1 and "Error in rule build" in output
    assert tree.text("build/workflow/soak.built.log") == "no room\n"
    assert not (tree.root / "build" / "reports").exists()


def test_jobs_of_kubernetes_are_parts(tree, site, kinds):
    tree.buildable()
    status, output = tree.snakemake(site, "--seconds-between-status-checks", "1", work="soak", soak_seeds=2)
    assert status == 0, output[-3000:]
    assert {(row["seeds"], row["results"]) for row in report(tree)["rows"]} == {(2, 10)}
    jobs = [json.loads(path.read_text())["spec"] for path in (tree.root / "jobs").glob("*.json")]
    asked = sorted((job["activeDeadlineSeconds"], *job["template"]["spec"]["containers"][0]["resources"]
                    ["requests"].values()) for job in jobs)
    assert asked == [(3600, "1", "2000M"), (7200, "4", "4000M"), (7200, "4", "4000M"), (21600, "8", "16000M")]
    for job in jobs:
        pod = job["template"]["spec"]
        container = pod["containers"][0]
        assert container["volumeMounts"] == [{"name": "checkout", "mountPath": str(tree.root)}]
        assert container["workingDir"] == str(tree.root / "build") and container["image"] == "hwffd-workflow"
        assert pod["volumes"] == [{"name": "checkout", "persistentVolumeClaim": {"claimName": "hwffd"}}]
        assert pod["securityContext"] == {"runAsUser": os.getuid(), "runAsGroup": os.getgid()}
        assert job["backoffLimit"] == 0


def test_a_job_of_kubernetes_that_fails_is_seen(tree, site):
    tree.buildable()
    tree.put({"bin/cmake": "#!/bin/sh\nexit 1\n"}, 0o755)
    status, output = tree.snakemake(site, "--seconds-between-status-checks", "1", "--retries", "0",
                                    work="soak", soak_seeds=2)
    assert status == 1 and "Error in rule build" in output
    assert len(list((tree.root / "jobs").glob("*.json"))) == 1


@pytest.fixture(name="called")
def _called(tree):
    """A program of the profile, with a kubectl of the shell: (exit status, what it printed, its complaint)"""
    def call(name, *words, kubectl):
        if kubectl:
            tree.put({"bin/kubectl": f"#!/bin/sh\n{kubectl}\n"}, 0o755)
        path = f"{tree.root}/bin{os.pathsep}{os.environ['PATH'] if kubectl else os.path.dirname(sys.executable)}"
        result = subprocess.run([sys.executable, "-B", WORKFLOW / "kubernetes" / name, *words], cwd=tree.root / "build",
                                env={**os.environ, "PATH": path}, capture_output=True, text=True, check=False)
        return result.returncode, result.stdout.strip(), result.stderr.strip()
    return call


@pytest.mark.parametrize("kubectl, word, complaint", (
    ("echo '{\"status\": {}}'", "running", ""),
    ("echo '{\"status\": {\"conditions\": [{\"type\": \"Complete\", \"status\": \"True\"}]}}'", "success", ""),
    ("echo '{\"status\": {\"conditions\": [{\"type\": \"Failed\", \"status\": \"True\"}]}}'", "failed", ""),
    ("echo '{\"status\": {\"conditions\": [{\"type\": \"Failed\", \"status\": \"False\"}]}}'", "running", ""),
    ("echo 'Error (NotFound): jobs x not found' >&2; exit 1", "failed", "status: Error (NotFound): jobs x not found"),
    ("echo no route to host >&2; exit 1", "running", "status: no route to host")))
def test_status(called, kubectl, word, complaint):
    assert called("status", "job.batch/x", kubectl=kubectl) == (0, word, complaint)


def test_cancel(called):
    assert called("cancel", "job.batch/x", "job.batch/y", kubectl="echo $* >&2; exit 1") == (
        1, "", "cancel: delete --wait=false --ignore-not-found job.batch/x job.batch/y")


def test_what_cannot_be_submitted_is_one_line(called, tree):
    asked = ("--image", "i", "--claim", "c", "--cores", "1", "--memory", "1", "--minutes", "1", "script", "--volume")
    assert called("submit", *asked, "/elsewhere", kubectl="exit 0") == (
        1, "", f"submit: {tree.root}/build is not on the volume at /elsewhere: clone there")
    assert called("submit", *asked, tree.root, kubectl="echo forbidden >&2; exit 1") == (1, "", "submit: forbidden")
    (tree.root / "bin" / "kubectl").unlink()
    assert called("submit", *asked, tree.root, kubectl="")[2].startswith("submit: kubectl not found: install")
