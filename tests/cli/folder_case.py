"""A test with a folder of its own, which is gone afterwards."""
import pathlib
import shutil
import tempfile
import unittest


class FolderCase(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix='rigsound_cli.'))
        self.addCleanup(shutil.rmtree, self.folder)
