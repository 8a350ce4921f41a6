"""Checks every #include of the rooms against the table of docs/architecture.md, section 2."""

import pathlib
import re
import sys

ROOMS = {
    "core": set(),
    "geometry": set(),
    "atmosphere": {"transport"},
    "protocol": set(),
    "transport": set(),
    "scheduler": {"transport", "protocol"},
    "camera": {"geometry"},
    "survey": {"geometry", "atmosphere"},
    "instrument": {"scheduler", "protocol", "geometry", "transport"},
    "video": {"camera"},
    "calibration": {"geometry", "camera"},
    "job": {"survey", "geometry"},
    "simulator": {"geometry", "atmosphere", "camera", "protocol", "transport"},
    "targeting": {"geometry", "camera", "instrument"},
    "routines": {"geometry", "protocol", "transport", "scheduler", "instrument"},
    "blackbox": set(),
    "app": {"geometry", "atmosphere", "protocol", "transport", "scheduler", "camera", "survey", "instrument", "video",
            "calibration", "job", "simulator", "targeting", "blackbox"},
    "gui": {"app", "camera"},
}

# Libraries and Qt modules a room may use beside QtCore, QCoro and expected.
LIBRARIES = {
    "Eigen": {"geometry", "camera", "survey", "instrument", "video", "calibration", "job", "simulator", "targeting", "app"},
    "opencv2": {"camera", "video", "calibration", "simulator", "targeting", "app", "gui"},
    "ceres": {"calibration"},
    "exiv2": {"job"},
    "gdal": {"job"},
    "ogr": {"job"},
    "QSerialPort": {"transport", "instrument"},
    "QNetwork": {"atmosphere"},
    "QWidget": {"gui"},
    "QApplication": {"gui"},
}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def breaches(root: pathlib.Path):
    for room in ROOMS:
        for folder in (root / "include/pmts" / room, root / "src" / room):
            for path in sorted(folder.rglob("*.[ch]pp")):
                for include in INCLUDE.findall(path.read_text(encoding="utf-8")):
                    yield from judge(room, path.relative_to(root), include)


def judge(room, path, include):
    if include.startswith("pmts/"):
        used = include.split("/")[1]
        if used not in ROOMS[room] | {room, "core"}:
            yield f"{path}: {room} may not use {used} ({include})"
        return
    for prefix, allowed in LIBRARIES.items():
        if include.startswith(prefix) and room not in allowed:
            yield f"{path}: {room} may not use {prefix} ({include})"


def main() -> int:
    found = list(breaches(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "every include follows the table")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
