"""Compiles the engine with mypyc where there is a C compiler; else sources run. `pyproject.toml` has the rest."""

from __future__ import annotations

import os
import sys
import sysconfig
import tempfile
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT))

from pool2d import compiled  # noqa: E402


class BuildEngine(build_ext):
    """Builds the extension modules, or, where that cannot be done, nothing."""

    def run(self) -> None:
        folder = Path(self.get_ext_fullpath("pool2d.physics.motion")).parent
        compiled.stamp(folder).unlink(missing_ok=True)
        try:
            self.check_compiler()
            self.extend(self.engine())
            super().run()
        except (Exception, SystemExit) as error:
            self.warn(f"the engine is not compiled, its sources will be run: {error}")
            self.extensions = []
            return
        compiled.stamp(folder).write_text(compiled.digest())

    def extend(self, made: list[Extension]) -> None:
        """Build these in place of what stood for them."""
        inplace, editable = self.inplace, self.editable_mode
        self.initialize_options()
        self.distribution.ext_modules = made
        self.inplace, self.editable_mode = inplace, editable
        self.finalize_options()

    def check_compiler(self) -> None:
        """Raises where an extension module cannot be compiled: before mypyc takes its time."""
        from setuptools._distutils.ccompiler import new_compiler
        from setuptools._distutils.sysconfig import customize_compiler

        compiler = new_compiler()
        customize_compiler(compiler)
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder) / "probe.c"
            source.write_text("#include <Python.h>\nint probe(void) { return PY_MAJOR_VERSION; }\n")
            include = sysconfig.get_paths()["include"]
            compiler.compile([str(source)], output_dir=folder, include_dirs=[include])

    def engine(self) -> list[Extension]:
        """The extension modules, as C sources that mypyc has written."""
        from mypyc.build import mypycify

        os.chdir(ROOT)
        files = [str(path.relative_to(ROOT)) for path in compiled.modules()]
        # What the engine does not import need not be there.
        options = [f"--config-file={os.devnull}", f"--cache-dir={self.build_temp}/mypy", "--ignore-missing-imports"]
        made = mypycify(
            [*options, *files], opt_level="3", debug_level="0", group_name=compiled.GROUP, target_dir=self.build_temp
        )
        for extension in made:
            if os.name == "posix":
                # A product and a sum rounded as one would be other bits than the interpreted engine's.
                extension.extra_compile_args.append("-ffp-contract=off")
        return made


# What it is made of is not known yet: asking mypyc takes its time, and most commands have no need of it.
setup(ext_modules=[Extension(f"{compiled.GROUP}__mypyc", [])], cmdclass={"build_ext": BuildEngine})
