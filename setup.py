"""Builds the Python module by CMake; pyproject.toml has the rest."""

from skbuild import setup

setup(
    packages=["clearway"],
    package_dir={"": "python"},
    package_data={"clearway": ["py.typed", "*.pyi"]},
    cmake_install_dir="python/clearway",
    cmake_args=["-DCMAKE_BUILD_TYPE=Release", "-DCLEARWAY_PYTHON=ON", "-DCLEARWAY_PYTHON_DIR=.", "-DCLEARWAY_INSTALL=OFF"]
    + ["-DBUILD_SHARED_LIBS=ON", "-DCLEARWAY_PLANNING=AUTO"]
    + ["-DCLEARWAY_%s=OFF" % name for name in ("PROGRAM", "DEMOS", "TESTS")],
)
