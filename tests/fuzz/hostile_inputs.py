# Inputs of hostile.py: prepared files of every kind, changed text, edited HDF5.
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import pathlib
import shutil
import subprocess

import h5py
import numpy as np

EXAMPLES = pathlib.Path(__file__).resolve().parent.parent / "tools" / "examples"
DATA = EXAMPLES.parent.parent.parent / "data"

# Numbers at their extremes, and words that are none.
WORDS = ["0", "-0", "nan", "inf", "-inf", "1e308", "-1e308", "1e-320", "-1", "9223372036854775808", "18446744073709551616",
         "1e18", "1.5", "1,5", "", "1e", "0x10", "1 kPa", "\u0661", "a" * 3000, "\x1b[31mred", "nan,nan,nan", "1,2,3,4,5,6,7"]
PIECES = [b"\0", b"\xef\xbb\xbf", b"\xff\xfe", b"\x1b]0;title\x07", b"\r\n", b"\r", b",", b";", b"\t\t", b"\xc2\xa0", b"#", b'"', b"[", b"]",
          b"-", b"e", b"[[", b"=", b"x" * 5000, b"1 " * 3000, b"[" * 300, b"a." * 2000, b"\n" * 200, b"\xc3\x28", b"$End", b"\x9b31m"]

CONTACT = '[contact]\nlaw = "hertz-mindlin"\nyoung_modulus = "4 GPa"\npoisson_ratio = 0.33\nfriction_angle = 29\n'
ELASTIC = ('[soil]\nmaterial = "elastic"\ndensity = 2000\nyoung_modulus = "10 MPa"\npoisson_ratio = 0.25\ndamping = 10\n'
           '[[support]]\non = "bottom"\nx = 0\ny = 0\n[[traction]]\non = "top"\ny = "-1 kPa"\n[time]\nduration = 0.05\n'
           'output_interval = 0.05\n')
CORNERS = [(x, y, z) for x in (-0.02, 0.02) for y in (-0.02, 0.02) for z in (-0.02, 0.02)]
FACES = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]


def text_stl():
    facets = ("facet normal 0 0 0\nouter loop\n" + "".join("vertex {} {} {}\n".format(*CORNERS[c]) for c in face) + "endloop\nendfacet\n"
              for face in FACES)
    return "solid cube\n" + "".join(facets) + "endsolid cube\n"


def binary_stl():
    triangle = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
    rows = np.zeros(len(FACES), triangle)
    rows["corners"] = [[CORNERS[c] for c in face] for face in FACES]
    return b"solid, but binary".ljust(80) + np.uint32(len(FACES)).tobytes() + rows.tobytes()


def triangles_msh():
    nodes = [(x / 2, y / 2) for y in range(3) for x in range(3)]
    sides = [(1, 1, 2), (1, 2, 3), (2, 9, 8), (2, 8, 7)]
    squares = [(x + 3 * y, x + 3 * y + 1, x + 3 * y + 4, x + 3 * y + 3) for y in range(2) for x in range(1, 3)]
    rows = [f"1 2 {g} {g} {a} {b}" for g, a, b in sides] + [f"2 2 3 1 {t}" for a, b, c, d in squares for t in (f"{a} {b} {c}", f"{a} {c} {d}")]
    return ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 1 \"bottom\"\n1 2 \"top\"\n2 3 \"soil\"\n$EndPhysicalNames\n"
            f"$Nodes\n{len(nodes)}\n" + "".join(f"{k + 1} {x} {y} 0\n" for k, (x, y) in enumerate(nodes)) + f"$EndNodes\n$Elements\n{len(rows)}\n"
            + "".join(f"{k + 1} {row}\n" for k, row in enumerate(rows)) + "$EndElements\n")


def quadrilateral_msh():
    return ("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"bottom\"\n1 2 \"top\"\n$EndPhysicalNames\n"
            "$Entities\n0 2 1 0\n1 0 0 0 1 0 0 1 -1 0\n2 0 1 0 1 1 0 1 2 0\n1 0 0 0 1 1 0 0 0\n$EndEntities\n$Nodes\n1 8 1 8\n2 1 0 8\n"
            "1\n2\n3\n4\n5\n6\n7\n8\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 0 0\n1 .5 0\n.5 1 0\n0 .5 0\n$EndNodes\n$Elements\n3 3 1 3\n"
            "1 1 8 1\n1 1 2 5\n1 2 8 1\n2 3 4 7\n2 1 16 1\n3 1 2 3 4 5 6 7 8\n$EndElements\n")


def prepare(tools, folder):
    """Files of every kind that tools read, small, into the folder."""
    def run(line):
        subprocess.run([tools / line.split()[0], *line.split()[1:]], cwd=folder, check=True, capture_output=True,
                       env={**os.environ, "OMP_NUM_THREADS": "1"})

    for name in ("spheres.txt", "observed.tsv", "runs.tsv", "prior.toml", "press.toml", "triaxial.toml"):
        shutil.copy(EXAMPLES / name, folder)
    shutil.copy(DATA / "gradings" / "toyoura.tsv", folder / "grading.tsv")
    shutil.copy(DATA / "soils" / "toyoura-gws.toml", folder / "soil.toml")
    shutil.copy(DATA / "geotextiles" / "PP.toml", folder / "geotextile.toml")
    texts = {
        "material.toml": CONTACT + '[contact.rolling]\nstiffness = 0.13\nlimit = "none"\n[grains]\ndensity = 2650e3\n',
        "cut.toml": '[container]\nshape = "surface"\nfile = "text.stl"\nscale = 1\n' + CONTACT,
        "bag.toml": (EXAMPLES / "bag.toml").read_text().split("[growth]")[0],
        "elastic.toml": "[mesh]\nwidth = 0.6\nheight = 0.3\ncolumns = 2\nrows = 1\n" + ELASTIC,
        "on_mesh.toml": ELASTIC,
        "lateral.tsv": "surcharge [kPa]\tlateral_stress [kPa]\n0\t0\n100\t10\n400\t20\n",
        "compression.tsv": "mean_stress [kPa]\tstrain_volumetric [%]\n10\t0.2\n100\t0.6\n300\t1.0\n800\t1.5\n",
        "text.stl": text_stl(),
        "triangles.msh": triangles_msh(),
        "quadrilaterals.msh": quadrilateral_msh(),
    }
    for name, text in texts.items():
        (folder / name).write_text(text)
    (folder / "binary.stl").write_bytes(binary_stl())
    run("pack-generate --quiet --grains 60 --void-ratio 0.8 --pressure 1e4 --tolerance 0.05 -o packing.h5")
    run("filter-expand --quiet packing.h5 bag.toml -o bag.h5")
    run("run-dem --quiet packing.h5 triaxial.toml --set stage.1.axial_strain=0.002 --set stage.1.increment=0.001 -o run.h5")
    run("homogenize --quiet run.h5 --grains -o fields.h5")
    run("pf-weight draw prior.toml -n 20 -o ensemble.h5")
    run("pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --variance 0.1 -o posterior.h5")
    run("fem-dem --quiet elastic.toml -o multiscale.h5")
    for line, name in (("pf-weight draw prior.toml -n 20 --tsv", "sets.tsv"), ("gws-solve respond --geotextile PP --tsv", "response.tsv")):
        text = subprocess.run([tools / line.split()[0], *line.split()[1:]], cwd=folder, check=True, capture_output=True).stdout
        (folder / name).write_bytes(text)


def keys_of(table, path=""):
    """Dotted keys of all numbers and texts of a TOML document, as --set takes them."""
    for key, value in (table.items() if isinstance(table, dict) else enumerate(table)):
        here = f"{path}.{key}" if path else str(key)
        if isinstance(value, (dict, list)):
            yield from keys_of(value, here)
        else:
            yield here


def changed_once(chance, text):
    if not text:
        return chance.choice(PIECES)
    at = chance.randrange(len(text))
    kind = chance.randrange(10)
    if kind == 0:
        return text[:at] + bytes([chance.randrange(256)]) + text[at + 1:]
    if kind == 1:
        return text[:at]
    if kind == 2:
        return text[:at] + text[at + chance.randrange(60):]
    if kind == 3:
        return text[:at] + text[at:at + chance.randrange(200)] + text[at:]
    if kind == 4:
        return text[:at] + chance.choice(PIECES) + text[at:]
    if kind == 5:
        lines = text.split(b"\n")
        chance.shuffle(lines)
        return b"\n".join(lines)
    if kind == 6:
        return text.replace(b".", b",")
    # A number, the first from here on, at an extreme.
    digits = b"0123456789.e+-"
    start = next((k for k in range(at, len(text)) if text[k] in b"0123456789"), None)
    if start is None:
        return text
    end = next((k for k in range(start, len(text)) if text[k] not in digits), len(text))
    return text[:start] + chance.choice(WORDS).encode() + text[end:]


def changed(chance, text):
    for _ in range(chance.randint(1, 3)):
        text = changed_once(chance, text)
    return text


def objects_of(file):
    names = []
    file.visit(names.append)
    return names


VALUES = [np.nan, np.inf, -np.inf, 1e308, -1.0, 0.0, 2.0**63, -2.0**31, 1e-320]


def edit_values(chance, data):
    values = data[()]
    if getattr(values, "size", 0) == 0 or values.dtype.kind not in "fiu":
        return
    flat = np.array(values).reshape(-1)
    value = chance.choice(VALUES)
    if flat.dtype.kind != "f":
        information = np.iinfo(flat.dtype)
        value = chance.choice([information.min, information.max, 0, min(information.max, 1 << 20)])
    flat[chance.randrange(flat.size) if chance.random() < 0.7 else slice(None)] = value
    data[...] = flat.reshape(np.shape(values))


def edit_shape(chance, file, name):
    data = file[name]
    attributes = dict(data.attrs)
    values, kind = np.array(data[()]), data.dtype
    del file[name]
    choice = chance.randrange(9)
    if choice == 0:
        file.create_dataset(name, (1 << chance.choice([31, 40, 62]),), kind, chunks=(1 << 16,))
    elif choice == 1:
        file.create_dataset(name, (1 << 27,), "f8", chunks=(1 << 20,), compression="gzip", fillvalue=1.0)[::1 << 25] = 2
    elif choice == 2:
        file[name] = values.reshape(-1)[: max(values.size - 1, 0)]
    elif choice == 3:
        file[name] = np.concatenate([values, values]) if values.ndim else np.array([values, values])
    elif choice == 4:
        file.create_dataset(name, data=h5py.Empty(kind if kind.kind in "fiu" else "f8"))
    elif choice == 5:
        file.create_group(name)
    elif choice == 6:
        file.create_dataset(name, (max(values.size, 1), 0), "f8")
    elif choice == 7:
        file.create_dataset(name, data=values.astype(chance.choice(["f2", "i1", ">f8", "c16", "S3", "u8", "?"])) if values.dtype.kind in "fiu"
                            else np.arange(3))
    if choice != 8:
        file[name].attrs.update({key: value for key, value in attributes.items() if not isinstance(value, h5py.Empty)})


def edit_links(chance, file, name, seeds):
    del file[name]
    choice = chance.randrange(5)
    if choice == 0:
        file[name] = h5py.ExternalLink(str(seeds / "packing.h5"), "/grains/position")
    elif choice == 1:
        file[name] = h5py.SoftLink(chance.choice(["/" + name, "/nowhere", "/"]))
    elif choice == 2:
        layout = h5py.VirtualLayout((4,), "f8")
        layout[:] = h5py.VirtualSource(str(seeds / "packing.h5"), "grains/radius", (4,))
        file.create_virtual_dataset(name, layout)
    elif choice == 3:
        file.create_dataset(name, (16,), "f8", external=[(str(seeds / "text.stl"), 0, 128)])
    else:
        file[name] = file["/"]  # a ring


def edit_attribute(chance, file, name):
    attributes = (file[name] if chance.random() < 0.7 else file).attrs
    keys = list(attributes)
    if not keys:
        return
    key = chance.choice(keys)
    del attributes[key]
    value = chance.choice([None, np.nan, -1, 1 << 62, "", "\x1b[31m" + "x" * 50, np.zeros(1000), np.arange(3), "9.9", h5py.Empty("f8")])
    if value is not None:
        attributes[key] = value


def change_hdf5(chance, path, seeds):
    """Flipped or missing bytes, or one object edited as a writer of HDF5 could."""
    kind = chance.randrange(10)
    if kind <= 2:
        data = bytearray(path.read_bytes())
        # The first kilobytes hold the metadata that describe the rest.
        reach = len(data) if chance.random() < 0.5 else min(len(data), 4096)
        for _ in range(chance.choice([1, 1, 4, 16])):
            data[chance.randrange(reach)] = chance.choice([0, 255, chance.randrange(256)])
        path.write_bytes(data)
    elif kind == 3:
        data = path.read_bytes()
        path.write_bytes(data[:chance.randrange(len(data))] if chance.random() < 0.8 else data + bytes(chance.randrange(1, 5000)))
    else:
        with h5py.File(path, "r+") as file:
            names = objects_of(file)
            sets = [name for name in names if isinstance(file[name], h5py.Dataset)]
            if kind == 4:
                del file[chance.choice(names)]
            elif kind == 5:
                edit_links(chance, file, chance.choice(names), seeds)
            elif kind == 6:
                edit_attribute(chance, file, chance.choice(names))
            elif kind == 7:
                edit_shape(chance, file, chance.choice(sets))
            else:
                edit_values(chance, file[chance.choice(sets)])
