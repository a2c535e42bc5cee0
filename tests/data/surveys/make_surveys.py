#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 The taut authors
# SPDX-License-Identifier: MIT
"""Writes one and the same survey in the formats that taut reads, to a tenth of a millimetre.

Usage: taut example hypar:4x5 -o net.json
       taut form net.json --prior uniform:2mm --seed 3 -o form.csv
       make_surveys.py form.csv [FOLDER]
"""

import csv
import random
import sys
from pathlib import Path


def tenths(text):
    """A coordinate in tenths of a millimetre, so that every format says the same number."""
    return round(float(text) * 1e4)


def metres(value):
    return f"{value / 1e4:.4f}"


def millimetres(value):
    return f"{value / 10:.1f}"


def own(points):
    return "id,x,y,z\n" + "".join(
        f"{name},{metres(x)},{metres(y)},{metres(z)}\n" for name, x, y, z in points)


def german(points):
    """Decimal commas, millimetres, columns in another order and one more, Latin-1."""
    def comma(value):
        return millimetres(value).replace(".", ",")
    lines = ["Netz Süd, Aufmaß vom 3. Mai", "Pkt-Nr;Höhe [mm];Rechtswert [mm];Hochwert [mm];Code"]
    lines += [f"{name};{comma(z)};{comma(x)};{comma(y)};Marke" for name, x, y, z in points]
    return ("\r\n".join(lines) + "\r\n").encode("latin-1")


def english(points):
    """Tabs, comments, UTF-16; every fifth point was measured twice, by 0.6 mm apart."""
    lines = ["// total station, second set", "Name\tEast\tNorth\tHeight\tRemark"]
    for i, (name, x, y, z) in enumerate(points):
        for offset in (-3, 3) if i % 5 == 0 else (0,):
            lines.append(f"{name}\t{metres(x)}\t{metres(y + offset)}\t{metres(z)}\tok")
    return "\ufeff".encode("utf-16-le") + ("\r\n".join(lines) + "\r\n").encode("utf-16-le")


def gsi(points, digits):
    """With the unit digit 6, tenths of a millimetre; a code and a station in between."""
    star = "*" if digits == 16 else ""

    def word(index, value, unit):
        sign = "-" if isinstance(value, int) and value < 0 else "+"
        return f"{index}{unit}{sign}{str(value).lstrip('-').rjust(digits, '0')}"
    lines = [star + " ".join([word("41", "1", "0001"), word("42", "0", "....")]),
             star + " ".join([word("11", "ST1", "0002"), word("84", 100000, "..46"),
                              word("85", -200000, "..46"), word("86", 15000, "..46")])]
    for number, (name, x, y, z) in enumerate(points, 3):
        lines.append(star + " ".join([word("11", name, f"{number:04d}"), word("81", x, "..46"),
                                      word("82", y, "..46"), word("83", z, "..46")]) + " ")
    return "\r\n".join(lines) + "\r\n"


def landxml(points):
    rows = "".join(f'    <CgPoint name="{name}" code="T">{metres(y)} {metres(x)} {metres(z)}</CgPoint>\n'
                   for name, x, y, z in points)
    return ('<?xml version="1.0" encoding="UTF-8"?>\n'
            '<LandXML xmlns="http://www.landxml.org/schema/LandXML-1.2" version="1.2">\n'
            '  <Units><Metric linearUnit="meter" areaUnit="squareMeter" volumeUnit="cubicMeter" '
            'temperatureUnit="celsius" pressureUnit="HPA"/></Units>\n'
            f"  <CgPoints>\n{rows}  </CgPoints>\n</LandXML>\n")


def jobxml(points):
    def grid(x, y, z):
        return f"<North>{metres(y)}</North><East>{metres(x)}</East><Elevation>{metres(z)}</Elevation>"
    records = "".join(
        f'    <PointRecord ID="{i:08d}"><Name>{name}</Name><Code>T</Code><Method>DirectReading</Method>'
        f"<ComputedGrid>{grid(x, y, z)}</ComputedGrid></PointRecord>\n"
        for i, (name, x, y, z) in enumerate(points, 1))
    deleted = ('    <PointRecord ID="99999999"><Name>0</Name><Deleted>true</Deleted>'
               f"<Grid>{grid(0, 0, 0)}</Grid></PointRecord>\n")
    return ('<?xml version="1.0" encoding="UTF-8"?>\n'
            '<JOBFile jobName="net" version="5.63" product="Trimble General Survey">\n'
            "  <Environment><DisplaySettings><DistanceUnits>Metres</DistanceUnits></DisplaySettings>"
            f"</Environment>\n  <FieldBook>\n{records}{deleted}  </FieldBook>\n</JOBFile>\n")


def gama(points):
    """Standard deviations of 0.2 mm, a band of one covariance beside each variance: 0 within a point,
    as the other formats have it."""
    rows = "".join(f"      <point><id>{name}</id><x>{metres(x)}</x><y>{metres(y)}</y>"
                   f"<z>{metres(z)}</z></point>\n" for name, x, y, z in points)
    dim = 3 * len(points)
    numbers = "".join(f"      <flt>4.0000000e-02</flt><flt>{'1.0e-03' if k % 3 == 2 else '0.0e+00'}</flt>\n"
                      for k in range(dim - 1))
    return ('<?xml version="1.0"?>\n'
            '<gama-local-adjustment xmlns="http://www.gnu.org/software/gama/gama-local-adjustment">\n'
            '  <network-general-parameters gama-local-version="2.23" axes-xy="en" '
            'angles="right-handed" epoch="0.0000000"/>\n'
            "  <coordinates>\n    <fixed>\n    </fixed>\n    <approximate>\n    </approximate>\n"
            f"    <adjusted>\n{rows}    </adjusted>\n    <orientation-shifts>\n    </orientation-shifts>\n"
            f"    <cov-mat>\n      <dim>{dim}</dim> <band>1</band>\n{numbers}"
            "      <flt>4.0000000e-02</flt>\n    </cov-mat>\n  </coordinates>\n"
            "</gama-local-adjustment>\n")


def dxf(points):
    """Points in millimetres, each with its name and its height as texts beside it."""
    pairs = [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015"), (9, "$INSUNITS"),
             (70, 4), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]
    for name, x, y, z in points:
        place = [(10, millimetres(x)), (20, millimetres(y)), (30, millimetres(z))]
        beside = [(10, millimetres(x + 200)), (20, millimetres(y + 100)), (30, millimetres(z))]
        below = [(10, millimetres(x + 200)), (20, millimetres(y - 300)), (30, millimetres(z))]
        pairs += [(0, "POINT"), (8, "TARGETS"), *place]
        pairs += [(0, "TEXT"), (8, "NAMES"), *beside, (40, "2.5"), (1, name)]
        pairs += [(0, "TEXT"), (8, "HEIGHTS"), *below, (40, "2.5"), (1, millimetres(z))]
    pairs += [(0, "LINE"), (8, "0"), (10, 0), (20, 0), (11, 1), (21, 1), (0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code:3d}\n{value}\n" for code, value in pairs)


def shuffled(points):
    points = list(points)
    random.Random(1).shuffle(points)
    return points


def pts(points):
    return f"{len(points)}\n" + "".join(
        f"{metres(x)} {metres(y)} {metres(z)} -1200 90 91 92\n" for _, x, y, z in shuffled(points))


def xyz(points):
    return "//X Y Z R G B\n" + "".join(
        f"{metres(x)} {metres(y)} {metres(z)} 90 91 92\n" for _, x, y, z in shuffled(points))


def main():
    if len(sys.argv) not in (2, 3):
        print(__doc__, file=sys.stderr)
        return 2
    with open(sys.argv[1], encoding="utf-8") as file:
        points = [(row["id"], tenths(row["x"]), tenths(row["y"]), tenths(row["z"]))
                  for row in csv.DictReader(file)]
    folder = Path(sys.argv[2] if len(sys.argv) > 2 else Path(__file__).parent)
    for name, content in {
            "own.csv": own(points), "german.csv": german(points), "english.txt": english(points),
            "gsi8.gsi": gsi(points, 8), "gsi16.gsi": gsi(points, 16), "landxml.xml": landxml(points),
            "jobxml.jxl": jobxml(points), "gama.xml": gama(points), "drawing.dxf": dxf(points),
            "scan.pts": pts(points), "scan.xyz": xyz(points)}.items():
        (folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())
    return 0


if __name__ == "__main__":
    sys.exit(main())
