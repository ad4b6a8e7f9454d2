// Readers that crash, do not end or take all memory are errors like any other.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <chrono>
#include <thread>

#include "child.hpp"
#include "errors.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "temp_folder.hpp"

namespace hwffd {
namespace {

constexpr ChildLimits kSmall{std::uint64_t{256} << 20, 1};

std::string failure_of(const std::function<std::string()>& work) {
  return message_of<ChildFailure>([&] { run_in_child(work, kSmall); });
}

TEST(Child, GivesItsResult) {
  const std::string all(1 << 20, 'x');
  EXPECT_EQ(run_in_child([&] { return all; }, kSmall), all);
  EXPECT_EQ(run_in_child([] { return std::string(); }, kSmall), "");
}

TEST(Child, ChangesNothingHere) {
  int value = 1;
  run_in_child([&] { return std::to_string(value = 2); }, kSmall);
  EXPECT_EQ(value, 1);
}

TEST(Child, ItsErrorsAreErrors) {
  EXPECT_ERROR(run_in_child([]() -> std::string { throw Error("broken"); }, kSmall), "broken");
}

TEST(Child, CrashesAlone) {
  EXPECT_EQ(failure_of([]() -> std::string { std::abort(); }), "its reader crashed: Aborted");
  EXPECT_EQ(failure_of([]() -> std::string {
              ::raise(SIGSEGV);
              return "";
            }),
            "its reader crashed: Segmentation fault");
}

TEST(Child, IsEndedWhenItDoesNotEnd) {
  EXPECT_EQ(failure_of([]() -> std::string {
              for (volatile int i = 0;; i = i + 1) {
              }
            }),
            "its reader does not end in 1 s");
  EXPECT_EQ(failure_of([]() -> std::string {
              std::this_thread::sleep_for(std::chrono::hours(1));
              return "";
            }),
            "its reader does not end in 1 s");
}

#ifndef __SANITIZE_ADDRESS__
TEST(Child, MemoryHasABound) {
  EXPECT_EQ(failure_of([] { return std::string(std::size_t{1} << 30, 'x'); }),
            "its reader needs more than 256 MB of memory");
}
#endif

TEST(Child, LeavesNoProcess) {
  run_in_child([] { return std::string(); }, kSmall);
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
}

/// Works where the program lets the kernel take children away.
TEST(Child, WithoutWaiting) {
  const auto handler = ::signal(SIGCHLD, SIG_IGN);
  const std::string result = run_in_child([] { return std::string("there"); }, kSmall);
  ::signal(SIGCHLD, handler);
  EXPECT_EQ(result, "there");
}

/// Assimp's reader of off files reads beyond its buffer here.
TEST(MeshReader, WhatCrashesAssimpIsAnError) {
  const TempFolder folder;
  const auto path = folder.write("a.off",
                                 "OFF\n5 2 0\n0 0 0\n9 9 9\n1 0 0\n1 1 0\n0 1 0\nnan2 3\n3 0 3 4\n"
                                 "0\nnan2 3\n3 0 3 4\n");
  EXPECT_ERROR_PART(Mesh::load(path),
                    "a.off: not a mesh that can be read ('nan2' is not a number of vertices or "
                    "faces)");
}

/// A file that refers to a pipe that nobody writes to, and to a device without end.
TEST(MeshReader, WaitsForNoPipeAndNoDevice) {
  const TempFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe.mtl").c_str(), 0600), 0);
  for (const std::string name : {"pipe.mtl", "/dev/zero"}) {
    const std::string text = "mtllib " + name + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(Mesh::load(folder.write("a.obj", text)).vertex_count(), 3u) << name;
  }
}

}  // namespace
}  // namespace hwffd
