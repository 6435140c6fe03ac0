"""Tables: columns of numbers, names and gaps, with and without numpy."""
import math
import unittest
from pathlib import Path
from unittest import mock

from quicksand import table
from quicksand.campaigns import mean_and_error
from support import InFolder, needs

TEXT = 'run,depth,grains,failure\n00012,1.5,3,"too ""deep"", it says"\n00013,,4,\n'


class Tables(InFolder):
    def read(self, text=TEXT):
        Path("table.csv").write_text(text)
        return table.Table.read("table.csv")

    def test_columns_are_numbers_names_and_gaps(self):
        one = self.read()
        self.assertEqual(list(one), ["run", "depth", "grains", "failure"])
        self.assertEqual(list(one["run"]), ["00012", "00013"])
        self.assertEqual(one["depth"][0], 1.5)
        self.assertTrue(math.isnan(one["depth"][1]))
        self.assertEqual(list(one["grains"]), [3, 4])
        self.assertEqual(list(self.read("run\n10000_1\n10000_2\n")["run"]), ["10000_1", "10000_2"])
        self.assertEqual(one["failure"][0], 'too "deep", it says')

    def test_true_and_false_are_no_texts(self):
        one = self.read("rest,gap,name\ntrue,false,true\nfalse,,x\n")
        self.assertEqual(list(one["rest"]), [True, False])
        self.assertFalse(one["rest"][1])
        self.assertEqual([row["gap"] for row in one.rows()], [False, None])
        self.assertEqual(list(one["name"]), ["true", "x"])

    def test_a_misspelt_column_has_a_nearest_name(self):
        with self.assertRaisesRegex(KeyError, "did you mean depth?"):
            self.read()["dept"]
        self.assertNotIn("dept", self.read())

    def test_rows_are_dicts(self):
        self.assertEqual(self.read().rows()[0]["grains"], 3)

    def test_a_torn_last_line_is_left_out(self):
        self.assertEqual(self.read("a,b\n1,2\n3").rows(), [{"a": 1, "b": 2}])

    def test_a_table_without_rows_keeps_its_names(self):
        empty = self.read("a,b\n")
        self.assertEqual((empty.height, list(empty)), (0, ["a", "b"]))

    def test_long_ones_show_their_ends(self):
        text = self.read("a\n" + "".join(f"{i}\n" for i in range(100)))._repr_html_()
        for row in ("<td>0</td>", "<td>99</td>", "90 rows"):
            self.assertIn(row, text)
        self.assertNotIn("<td>50</td>", text)

    def test_columns_are_lists_without_numpy(self):
        with mock.patch.object(table, "numpy", None):
            self.assertEqual(self.read()["grains"], [3, 4])


@needs("numpy")
class Arrays(InFolder):
    def test_are_the_columns(self):
        Path("table.csv").write_text(TEXT)
        self.assertEqual(table.Table.read("table.csv")["grains"].sum(), 7)


class MeanAndError(unittest.TestCase):
    def test_is_the_standard_error_of_the_mean(self):
        self.assertEqual(mean_and_error([1.0, 3.0]), (2, 1))
        self.assertEqual(mean_and_error([1.0, math.nan, 3.0]), (2, 1))

    def test_of_one_value_or_none_is_unknown(self):
        self.assertTrue(math.isnan(mean_and_error([5.0])[1]))
        self.assertTrue(all(map(math.isnan, mean_and_error([]))))


if __name__ == "__main__":
    unittest.main()
