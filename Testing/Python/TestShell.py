# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause
"""Commands in the documentation name files, programs, options and presets that there are.

The commands themselves are not run: those that take no minutes are run by tests of what they show.
"""

import json
import pathlib
import re
import shlex
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAMS = {"bash", "build/program", "cmake", "cpack", "export", "godrays", "make-mesh", "mpirun", "paraview", "pvbatch",
    "python3", "sudo", "/usr/bin/python3", "venv/bin/pip", "venv/bin/python", "xvfb-run"}


def find_pages():
    folders = "Documentation", "Examples", "Plugin"
    return [*ROOT.glob("*.md"), *(page for folder in folders for page in (ROOT / folder).rglob("*.md"))]


def find_commands():
    """(page, line, words) of each command: blocks of sh, and indented lines that begin with a program."""
    for page in sorted(find_pages()):
        language, before = None, ""
        for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
            if line.startswith("```"):
                language = (line[3:] or "text") if language is None else None
            elif language == "sh" or (language is None and line.startswith("    ")):
                text = before + line.strip()
                before = text.removesuffix("\\") if text.endswith("\\") else ""
                if before or text.count("'") % 2:
                    continue
                for part in re.split(r"\s(?:&&|\|)\s", re.sub(r"\s#\s.*", "", text)):
                    words = shlex.split(part)
                    while words and re.fullmatch(r"[A-Z_]+=.*", words[0]):
                        words.pop(0)
                    if words and (words[0] in PROGRAMS or words[0].startswith("build/bin/")):
                        yield page, number, words


class Shell(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.commands = list(find_commands())

    def for_each(self, check):
        for page, number, words in self.commands:
            with self.subTest(f"{page.relative_to(ROOT)}:{number}: {' '.join(words)}"):
                check(page, words)

    def test_there_are_some(self):
        self.assertGreater(len(self.commands), 80)
        self.assertGreater(len({words[0] for _, _, words in self.commands}), 15)

    def test_files_and_programs_are_there(self):
        lists = "".join((ROOT / folder / "CMakeLists.txt").read_text(encoding="utf-8")
            for folder in ("Examples", "Examples/godrays", "Testing"))
        made = set(re.findall(r"\w+", lists))

        def check(page, words):
            for word in words:
                if re.match(r"(\./)?(CMake|Documentation|Examples|Filters|Plugin|Rendering|Testing|\.ci)/", word):
                    self.assertTrue((ROOT / word).exists(), word)
                elif word.startswith("build/bin/"):
                    self.assertIn(word.removeprefix("build/bin/"), made)
            if words[0] == "pvbatch" and page.parent.name == "ParaView":
                self.assertTrue((page.parent / words[1]).exists(), words[1])

        self.for_each(check)

    def test_presets_and_settings_of_cmake(self):
        presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))
        names = {each["name"] for each in presets["configurePresets"]}
        text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")

        def check(_, words):
            for word, following in zip(words, [*words[1:], ""]):
                if word == "--preset" and words[0] == "cmake":
                    self.assertIn(following, names)
                elif word.startswith("-DGODRAYS_"):
                    self.assertRegex(text, rf"(option|set)\({word[2:].split('=')[0]}\b")

        self.for_each(check)

    def test_options_of_the_program(self):
        # the table is compared with the program's own by cli.test_output
        table = (ROOT / "Examples" / "godrays" / "README.md").read_text(encoding="utf-8")
        options = set(re.findall(r"(?m)`(--?[\w-]+)[^`\n]*`(?=.*\|$)", table)) | {"-"}
        gallery = (ROOT / "Documentation" / "Gallery" / "README.md").read_text(encoding="utf-8")

        def check(_, words):
            if words[0].rpartition("/")[2] != "godrays":
                return
            for word, following in zip(words, [*words[1:], ""]):
                if word.startswith("-"):
                    self.assertIn(word.split("=")[0], options)
                if word == "--preset":
                    self.assertIn(f"`{following}`", gallery)

        self.for_each(check)


if __name__ == "__main__":
    unittest.main()
