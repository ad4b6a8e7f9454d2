"""make words: error of every word length, measured and proved.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import listing

PICTURE_WIDTH = 4096  # pixels that the points' range, [-1, 1), is drawn on
HALF_PIXEL = 1 / PICTURE_WIDTH


def is_fixed(row):
    return row["format"].startswith("fx")


def shortest(rows, form, field, limit):
    """Bits of the shortest fixed-point word whose error is at most `limit`; None if none is."""
    return min((row["word_length"] for row in rows
                if is_fixed(row) and row["form"] == form and row[field] <= limit), default=None)


def as_binary32(rows, form, name, field="max_error"):
    """Bits of the shortest word as accurate as binary32 in the order of operations of that name."""
    limit = next(row[field] for row in rows if (row["form"], row["format"]) == (form, name))
    return shortest(rows, form, field, limit)


def forms(rows):
    return list(dict.fromkeys(row["form"] for row in rows))


def lengths(reports):
    rows = [{**row, "ratio": row["bound"] / row["max_error"]} for row in reports.rows("words")]
    return listing(rows, "form | form", "format | `format`", "bits | word_length",
                   "max error | max_error:.2e", "rms error | rms_error:.2e", "bound | bound:.2e",
                   "bound / max | ratio:.1f", "vertices | vertices")


def printed(reports):
    rows = reports.rows("words")
    lines = [lengths(reports).text(), ""]
    for form in forms(rows):
        bits = [as_binary32(rows, form, name, field)
                for name in ("fp32-sequential", "fp32-tree") for field in ("max_error", "rms_error")]
        lines += [
            "{}: as accurate as binary32 in sequence: {} bits by max, {} by rms; as its tree: {} "
            "and {}".format(form, *bits),
            f"{form}: within half a pixel of {PICTURE_WIDTH} ({HALF_PIXEL:.2e}): "
            f"{shortest(rows, form, 'max_error', HALF_PIXEL)} bits measured, "
            f"{shortest(rows, form, 'bound', HALF_PIXEL)} bits proved"]
    return "\n".join(lines)


def missing(reports):
    return "" if len(reports.rows("words")) >= 25 else "word lengths"


def _of_product(function, *arguments):
    return lambda reports: function(reports.rows("words"), "product", *arguments)


TABLES = {"lengths": lengths}
FIGURES = {
    "half_pixel_measured": _of_product(shortest, "max_error", HALF_PIXEL),
    "half_pixel_proved": _of_product(shortest, "bound", HALF_PIXEL),
    "as_binary32_sequence": _of_product(as_binary32, "fp32-sequential"),
    "as_binary32_tree": _of_product(as_binary32, "fp32-tree"),
    "vertices": lambda reports: reports.rows("words")[0]["vertices"],
}
