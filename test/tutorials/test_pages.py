# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
"""Pages are taken apart and run as a reader would."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))
import pages


class Pages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.page = self.folder / "page.md"

    def run_page(self, text):
        self.page.write_text(text)
        pages.run(self.page, self.folder, {"WORD": "hello"})

    def test_blocks_have_kind_text_and_file(self):
        self.page.write_text("# A\n\n`a/b.py`:\n\n```python\nx\n\ny\n```\n\n    indented\n\n```sh\nz\n```\n")
        first, second = pages.blocks(self.page)
        self.assertEqual(first, ("python", "x\n\ny\n", "a/b.py", 5))
        self.assertEqual(second, ("sh", "z\n", None, 13))
        self.page.write_text("```sh\nls\n")
        self.assertRaises(ValueError, pages.blocks, self.page)

    def test_what_is_said_may_be_off_a_little(self):
        told = "rooms:  3\narea 18.21 m^2, 1,204 points\n"
        for line in ("rooms: 3", "area 18.5 m^2, 1,200 points", "area ... points", "  rooms:   3"):
            self.assertTrue(pages.says(told, line), line)
        for line in ("rooms: 4", "area 20 m^2, 1,204 points", "room: 3", "area ... lines", ""):
            self.assertFalse(pages.says(told, line), line)

    def test_runs_files_and_commands_in_order(self):
        self.run_page("`a.txt`:\n\n```text\n7 rooms\n```\n\n```sh\ncat a.txt\necho $WORD\n```\n\n```text\n7 rooms\nhello\n```\n")

    def test_fails_where_a_reader_would(self):
        fine = "```sh\necho a\n```\n\n```text\na\n```\n"
        self.run_page(fine)
        for wrong in (
            fine.replace("echo a", "false | echo a"),
            fine.replace("echo a", "no_such_program; echo a"),
            fine.replace("text\na", "text\nb"),
            fine + "```python\nprint(1)\n```\n",  # of no file
            fine.replace("```text\na\n```\n", ""),
            "Nothing.\n",
        ):
            with self.assertRaises(AssertionError, msg=wrong):
                self.run_page(wrong)


if __name__ == "__main__":
    unittest.main()
