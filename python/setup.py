"""Builds the module with CMake, as a wheel: pip install --no-build-isolation ./python"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent


def version():
    project = (ROOT / "CMakeLists.txt").read_text()
    return re.search(r"project\(\s*blossom\s+VERSION ([\d.]+)", project)[1]


class CMakeBuild(build_ext):
    """The package as CMake lays it out: the compiled module and what is generated with it."""

    def run(self):
        build = Path(os.environ.get("BLOSSOM_WHEEL_BUILD", ROOT / "build" / "wheel"))
        options = [
            "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=16",
            "-DBLOSSOM_BUILD_PYTHON=ON", "-DBLOSSOM_BUILD_CLI=OFF", "-DBLOSSOM_BUILD_TESTS=OFF",
            f"-DPython_EXECUTABLE={sys.executable}",
        ]  # fmt: skip
        if shutil.which("ninja"):
            options += ["-G", "Ninja"]
        if shutil.which("ccache"):
            options += ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]
        subprocess.run(["cmake", "-S", ROOT, "-B", build, *options], check=True)
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", build, "--target", "blossom_python", "--parallel", jobs], check=True)
        target = HERE / "blossom" if self.inplace else Path(self.build_lib) / "blossom"
        target.mkdir(parents=True, exist_ok=True)
        for made in (build / "python" / "blossom").iterdir():
            if not made.is_symlink() and made.suffix in (".so", ".pyd", ".pyi"):
                shutil.copy2(made, target / made.name)


setup(
    version=version(),
    packages=["blossom"],
    package_dir={"blossom": str(Path("blossom"))},
    package_data={"blossom": ["py.typed"]},
    ext_modules=[Extension("blossom._engine", [])],
    cmdclass={"build_ext": CMakeBuild},
)
