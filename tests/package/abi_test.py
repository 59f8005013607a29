#!/usr/bin/env python3
"""What scripts/abi.py lets pass: versions and lists that are made up."""
import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
import abi


def at(minor, soversion):
    return {"VERSION_MAJOR": 0, "VERSION_MINOR": minor, "VERSION_PATCH": 0, "SOVERSION": soversion}


class Fault(unittest.TestCase):
    def test_what_is_not_released_may_change(self):
        self.assertIsNone(abi.fault(at(2, 0), {"a"}, {(0, 2): (0, {"b"})}, set()))

    def test_what_is_released_stays(self):
        lists = {(0, 2): (0, {"a"})}
        self.assertIsNone(abi.fault(at(2, 0), {"a"}, lists, {(0, 2)}))
        self.assertIn("raise the minor version", abi.fault(at(2, 0), {"a", "b"}, lists, {(0, 2)}))
        self.assertIn("raise the minor version", abi.fault(at(2, 1), {"a"}, lists, {(0, 2)}))

    def test_an_addition_needs_a_minor_version(self):
        self.assertIsNone(abi.fault(at(3, 0), {"a", "b"}, {(0, 2): (0, {"a"})}, {(0, 2)}))

    def test_a_removal_needs_a_soversion(self):
        lists = {(0, 2): (0, {"a", "b"}), (0, 3): (0, {"a"})}
        self.assertIn("raise SOVERSION", abi.fault(at(3, 0), {"a"}, lists, {(0, 2)}))
        self.assertIsNone(abi.fault(at(3, 1), {"a"}, lists, {(0, 2)}))

    def test_the_last_release_counts(self):
        lists = {(0, 2): (0, {"a", "b"}), (0, 3): (1, {"a"}), (0, 4): (1, {"a"})}
        self.assertIsNone(abi.fault(at(5, 1), {"a"}, lists, {(0, 2), (0, 3)}))
        self.assertIn("1 lines of 0.3 are gone", abi.fault(at(5, 1), set(), lists, {(0, 2), (0, 3)}))


class Changelog(unittest.TestCase):
    def test_headings_say_what_is_released(self):
        text = "# Changelog\n\n## Unreleased\n\n### Added\n\n## 0.10.2 (2027-01-01)\n- 0.9.0\n\n## 0.1.0\n"
        self.assertEqual(abi.released(text), {(0, 10), (0, 1)})


if __name__ == "__main__":
    unittest.main()
