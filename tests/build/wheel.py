"""Packs the Python module and its shared library as a wheel, which pip installs: wheel.py VERSION LIBRARY FOLDER"""

import base64
import hashlib
import pathlib
import sys
import sysconfig
import zipfile

NAME = "gjk_exact"
WHEEL = """Wheel-Version: 1.0
Generator: wheel.py
Root-Is-Purelib: false
Tag: {tag}
"""
METADATA = """Metadata-Version: 2.1
Name: gjk-exact
Version: {version}
Summary: Exact collision queries in Q16.16, and a second opinion on float geometry
License: none has been chosen yet
Requires-Python: >=3.9
Provides-Extra: numpy
Requires-Dist: numpy; extra == "numpy"
Description-Content-Type: text/markdown

{readme}"""


def main(version, library, folder):
    root = pathlib.Path("port/python")
    tag = "py3-none-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")
    about = f"{NAME}-{version}.dist-info"
    files = {str(path.relative_to(root)): path.read_bytes() for path in sorted(root.glob("gjk/**/*.py"))}
    files["gjk/py.typed"] = b""
    files["gjk/libgjk.so"] = pathlib.Path(library).read_bytes()
    files[f"{about}/LICENCE.txt"] = pathlib.Path("port/package/LICENCE.txt").read_bytes()
    files[f"{about}/METADATA"] = METADATA.format(version=version, readme=(root / "README.md").read_text()).encode()
    files[f"{about}/WHEEL"] = WHEEL.format(tag=tag).encode()
    record = ""
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(content)}\n"
    files[f"{about}/RECORD"] = (record + f"{about}/RECORD,,\n").encode()
    with zipfile.ZipFile(pathlib.Path(folder) / f"{NAME}-{version}-{tag}.whl", "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, content in files.items():
            # One time for all, so that equal files make equal wheels.
            wheel.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), content, zipfile.ZIP_DEFLATED)


if __name__ == "__main__":
    main(*sys.argv[1:])
