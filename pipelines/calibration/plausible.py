"""Checks tables of drained triaxial compression: refuses rows that no such test gives, and doubts unusual ones."""
# SPDX-License-Identifier: GPL-3.0-or-later
import math

import numpy
from study import StudyError

# Stress ratios between which every row lies. A piston's friction may pull a little; 15 is a friction angle of 61 deg.
LEAST_RATIO, GREATEST_RATIO = 0.9, 15
# Stress ratio that seating may leave at rest, and the axial strain (%) up to which a row counts as at rest: sand of 100 MPa at 20 kPa
# reaches 1.25 there.
SEATED, AT_REST = 1.3, 0.005
# A test whose stress ratio stays below this value has not compressed the soil.
NO_STRENGTH = 1.05
# Range of axial strains (%), greatest volumetric strain (%), and by how much (%) it may exceed the greatest axial strain so far.
AXIAL, VOLUMETRIC, VOLUMETRIC_BEYOND_AXIAL = (-5, 100), 30, 2
# Friction angles (deg): range of granular soils; usual difference of two tests of one soil; its increase per decade of pressure, as
# the angle of dense sand falls by 7 deg over a decade (Bolton, 1986); and the difference that one soil cannot have.
FRICTION, APART, APART_PER_DECADE, IMPOSSIBLY_APART = (22, 55), 5, 7, 20
# Differences of the stress ratio and the volumetric strain (%) that exceed the scatter of a measurement.
CLEAR_RATIO, CLEAR_VOLUME = 0.3, 0.25
# Stress ratio up to which shearing has hardly begun, and the axial strain (%) that seating leaves there.
BEGUN, CLEAR_AXIAL = 1.1, 0.5
# Expansion before the greatest contraction that exceeds the scatter: over that contraction, and in %.
EXPANSION, LEAST_EXPANSION = 0.01, 0.1
# Axial strain (%) that tests to failure exceed. A fraction of up to 30 % in a column headed [%] ends below it.
LEAST_AXIAL = 0.35
# Range of volumetric strains (%) that a drained test exceeds, and its least and greatest share of the greatest axial strain. A test that
# dilates early has contracted by 0.1 % before; at large strains the volume has changed by more.
LEAST_VOLUMETRIC, LEAST_SHARE, GREATEST_SHARE = 0.1, 0.01, 0.05
# A row falls back if it lies below this share of the greatest axial strain before it, which a loop of unloading hardly does; a second
# test begins below the other share. Share of all rows that may fall back.
BACK, BEGINS_AGAIN, MOST_BACK = 0.95, 0.2, 0.2
# Share of rows at which the stress ratio may turn by more than CLEAR_RATIO: rows of two tests, sorted by strain, turn at most rows.
TURNING = 0.1
# Greatest variation of the pore pressure in a drained test, over the confining pressure.
DRAINED = 0.1
# An outlier differs from the rows beside it by more than TOWERING times the range of all other rows, and by more than STEPS of the
# steps near it. LONGEST: the most outliers in a row.
TOWERING, STEPS, LONGEST = 0.2, 3, 3
# Shares of the greatest value below which a cell is empty, and above which its neighbours are not.
EMPTY, FILLED = 1e-3, 0.05


def friction_angle(ratio):
    """Returns the friction angle (deg) that a stress ratio mobilises without cohesion."""
    return math.degrees(math.asin((ratio - 1) / (ratio + 1)))


def _empty(values, rising, clear):
    """Returns the mask of rising rows that hold 0 although the rows beside them, of one sign, clearly differ from 0."""
    rows = numpy.flatnonzero(rising)
    size = abs(values[rows])
    full = numpy.flatnonzero(size > EMPTY * size.max(initial=0))
    wrong = numpy.zeros(len(values), bool)
    for k in set(range(len(rows))) - set(full):
        before, after = full[full < k][-1:], full[full > k][:1]
        beside = values[rows[[*before, *after]]]
        wrong[rows[k]] = len(before) and (abs(beside) > max(clear, FILLED * size.max())).all() and abs(numpy.sign(beside).sum()) == len(beside)
    return wrong


def _refusals(curve):
    """Yields pairs: a mask of impossible rows, and a function that returns the message for one of these rows."""
    ratio, axial, volumetric = curve.ratio, curve.axial, curve.volumetric
    source = "deviatoric_stress, its unit" if curve.stress == "deviatoric_stress" else "stress_ratio"
    yield ~((axial > AXIAL[0]) & (axial < AXIAL[1])), lambda k: (
        f"the axial strain is {axial[k]:.4g} %: compression is positive; correct the row, or the unit of the column, as [%] or [1]")
    yield ~(ratio >= LEAST_RATIO), lambda k: (
        f"axial over radial stress is {ratio[k]:.4g}, where compression has 1 at rest and more after it: correct {curve.stress}"
        + (", which is neither q/p nor q over the radial stress" if curve.stress == "stress_ratio" else ""))
    yield ~(ratio <= GREATEST_RATIO), lambda k: (
        f"axial over radial stress is {ratio[k]:.4g}, where no soil bears more than {GREATEST_RATIO}: check {source} and the confining pressure")
    yield (axial <= AT_REST) & (ratio > SEATED), lambda k: (
        f"axial over radial stress is {ratio[k]:.4g} at an axial strain of {axial[k]:.3g} %, where tests from isotropic stress have 1: check "
        f"{curve.stress}" + (", which is the axial less the radial stress" if curve.stress == "deviatoric_stress" else "")
        + (f", and the axial strain, which ends at {axial.max():.2g} %, as a fraction headed [%] does" if axial.max() < LEAST_AXIAL else ""))
    most = numpy.minimum(VOLUMETRIC, numpy.maximum.accumulate(abs(axial)) + VOLUMETRIC_BEYOND_AXIAL)
    yield ~(abs(volumetric) < most), lambda k: (
        f"the volumetric strain is {volumetric[k]:.4g} % at an axial strain of {axial[k]:.4g} %, more than a drained test has: correct the row, or "
        "the unit of one of the columns, as [%] or [1]")
    for name, values, clear in ((curve.stress, ratio - 1, CLEAR_RATIO), ("volumetric strain", volumetric, CLEAR_VOLUME)):
        yield _empty(values, curve.rising, clear), lambda k, name=name: (
            f"{name} falls to nothing at an axial strain of {axial[k]:.4g} %, where rows beside it do not: leave out rows without a value")


def constant_volume(curve):
    """Returns whether the volumetric strain changes so little as in an undrained test with noise."""
    axial = curve.axial.max()
    return bool(numpy.ptp(curve.volumetric) < min(max(LEAST_VOLUMETRIC, LEAST_SHARE * axial), GREATEST_SHARE * axial))


def _disorder(curve):
    """Yields pairs like _refusals(): rows of a second test, and rows in another order than the test's."""
    before = numpy.maximum.accumulate(numpy.append(0, curve.axial[:-1]))
    yield (before > CLEAR_AXIAL) & (curve.axial < BEGINS_AGAIN * before), lambda k: (
        f"the axial strain falls back from {before[k]:.4g} to {curve.axial[k]:.4g} %, as where a second test begins: give each test a table of its "
        "own, with its rows in the order of the test, or correct the row")
    back = curve.axial < BACK * before
    yield back & (back.sum() > max(1, MOST_BACK * len(back))), lambda k: (
        f"here the axial strain first falls back, from {before[k]:.4g} to {curve.axial[k]:.4g} %, and {back.sum()} of {len(back)} rows lie below a strain "
        "before them: sort the rows in the order of the test, give each test a table of its own, or leave out rows of unloading")


def judge(curve):
    """Raises StudyError, with file and row, for a curve that no drained test from isotropic stress gives."""
    for wrong, said in (*_refusals(curve), *_disorder(curve)):
        if wrong.any():
            row = int(numpy.argmax(wrong))
            raise StudyError(f"{curve.test.table}: row {row + 1}: {said(row)}")
    if curve.strength < NO_STRENGTH:
        raise StudyError(f"{curve.test.table}: axial over radial stress never exceeds {curve.strength:.4g}: check the unit of {curve.stress} and "
                         "the confining pressure")
    for name in curve.pore_pressures:
        pore = curve.table(name, "Pa", missing=True)
        if constant_volume(curve):
            raise StudyError(f"{curve.test.table}: is an undrained test by its {name}, at a constant volume: give drained ones, or correct the unit of the "
                             "volumetric strain")
        if numpy.nanmax(pore) - numpy.nanmin(pore) > DRAINED * curve.test.pressure:
            raise StudyError(f"{curve.test.table}: is an undrained test by its {name}, at rising or falling pore pressure: give drained ones")


def _towering(strain, values, clear):
    """Returns the first row of a short run that lies far beyond the rows on both sides of it, or None.

    Rows are those of rising strain, the first one at rest. The last row is compared with the slope before it.
    """
    steps, count = numpy.diff(values), len(values)

    def far(rows, height, others):
        return height > max(clear, STEPS * max(others, default=0)) and height > TOWERING * numpy.ptp(numpy.delete(values, rows))
    for length in range(1, LONGEST + 1):
        for k in range(1, count - length):
            up, down = steps[k - 1], steps[k + length - 1]
            others = [abs(values[k + length] - values[k - 1]), *abs(steps[max(k - 2, 0):k - 1]), *abs(steps[k + length:k + length + 1])]
            if up * down < 0 and far(range(k, k + length), min(abs(up), abs(down)), others):
                return k
    if count > LONGEST:
        stretch = max(1, (strain[-1] - strain[-2]) / (strain[-2] - strain[-3]))
        if far([count - 1], abs(steps[-1]), stretch * abs(steps[-3:-1])):
            return count - 1
    return None


def _of_units_and_order(curve):
    """Yields sentences on strains that look like another unit, and on rows that are left out or mixed."""
    for name in curve.without_unit:
        yield f"{name} has no unit and is taken for a fraction; write [%] or [1]"
    if curve.axial.max() < LEAST_AXIAL:
        yield (f"the axial strain ends at {curve.axial.max():.3g} %, where tests to failure reach some per cent: if it is a fraction, head its column [1] "
               "in place of [%]")
    if constant_volume(curve):
        yield (f"the volumetric strain changes by {numpy.ptp(curve.volumetric):.2g} % in all, while the axial strain reaches {curve.axial.max():.3g} %: give a "
               "drained test if this one is undrained, or head the column [1] if it is a fraction headed [%]")
    # Rows up to the first strain above 0 are the start of the test.
    count = int(((numpy.maximum.accumulate(curve.axial) > 0) & ~curve.rising).sum())
    if count:
        yield (f"{count} of {len(curve.axial)} rows are left out, since the axial strain does not rise there, as in unloading: check the order of the rows "
               "if the test was not unloaded")
    steps = numpy.diff(curve.ratio[curve.rising])
    turns = int(((steps[1:] * steps[:-1] < 0) & (numpy.minimum(abs(steps[1:]), abs(steps[:-1])) > CLEAR_RATIO)).sum())
    if turns > max(2, TURNING * len(steps)):
        yield (f"{curve.stress} jumps up and down at {turns} of {len(steps)} rows, as where rows of two tests are mixed: give each test a table of its own, "
               "or leave out rows that are errors")


def doubts(curve):
    """Returns sentences on what is unusual in the table of a test."""
    said, rows = list(_of_units_and_order(curve)), numpy.flatnonzero(curve.rising)
    begun = int(rows[0]) if curve.ratio[rows[0]] < BEGUN else 0
    for name, value, clear in (("axial", curve.axial[begun], CLEAR_AXIAL), ("volumetric", curve.volumetric[begun], CLEAR_VOLUME)):
        if curve.ratio[begun] < BEGUN and abs(value) > clear:
            said.append(f"the {name} strain is {value:.3g} % in row {begun + 1}, where axial over radial stress is still {curve.ratio[begun]:.4g}: strains "
                        "count from the end of the isotropic compression; subtract what was there before")
    most = int(curve.volumetric.argmax())
    contraction, expansion = curve.volumetric[most], -curve.volumetric[:most + 1].min()
    if contraction == abs(curve.volumetric).max() and expansion > max(LEAST_EXPANSION, EXPANSION * contraction):
        said.append("the volume expands first and contracts then, where tests do the opposite: contraction is positive; change the signs of the "
                    "volumetric strain if they are others")
    for name in curve.unread:
        said.append(f"the column {name} is not read" + (
            ", and the confining pressure has to be the effective one" if name in curve.pore_pressures else ""))
    for name, at_rest, values, clear in ((curve.stress, 1, curve.ratio, CLEAR_RATIO), ("the volumetric strain", 0, curve.volumetric, CLEAR_VOLUME)):
        found = _towering(numpy.append(0, curve.axial[rows]), numpy.append(at_rest, values[rows]), clear)
        if found:
            row = rows[found - 1]
            said.append(f"{name} of row {row + 1}, at an axial strain of {curve.axial[row]:.4g} %, lies far from the rows beside it: leave it out if it "
                        "is an error")
    angle = friction_angle(curve.strength)
    if angle > FRICTION[1] or (angle < FRICTION[0] and not curve.still_rises):
        said.append(f"its friction angle is {angle:.3g} deg, where granular soils have {FRICTION[0]} to {FRICTION[1]}: check its stress and its "
                    "confining pressure")
    return [f"{curve.test.table}: {one}" for one in said]


def compared(curves):
    """Returns doubts about tests whose strengths hardly fit one soil. Raises StudyError for strengths that cannot fit.

    Compares tests that have passed their peak, and tests of one packing: tests of two packings may be loose and dense.
    """
    said, peaked = [], sorted((c for c in curves if not c.still_rises), key=lambda c: c.test.pressure)
    for k, low in enumerate(peaked):
        for high in (c for c in peaked[k + 1:] if c.test.packing == low.test.packing):
            angles = [friction_angle(c.strength) for c in (low, high)]
            apart, decades = abs(angles[0] - angles[1]), math.log10(high.test.pressure / low.test.pressure)
            words = (f"friction angles are {angles[0]:.3g} deg at {low.test.pressure / 1e3:g} kPa ({low.test.table}) and {angles[1]:.3g} deg at "
                     f"{high.test.pressure / 1e3:g} kPa ({high.test.table})")
            if apart > IMPOSSIBLY_APART:
                raise StudyError(f"{words}, which one soil does not have: correct the confining pressures, or the stresses")
            if apart > APART + APART_PER_DECADE * decades:
                said.append(f"{words}, far apart for one soil: check the confining pressures")
    return said


def _rows(curve):
    """Returns the rows of rising strain as a set of rounded numbers."""
    columns = numpy.stack([curve.axial, curve.ratio, curve.volumetric], axis=1)[curve.rising]
    return {tuple(f"{value:.4g}" for value in row) for row in columns}


def distinct(curves):
    """Raises StudyError where most rows of one test are rows of another: one test would be counted twice, or predict itself."""
    rows = [_rows(curve) for curve in curves]
    for k, one in enumerate(rows):
        for other, curve in zip(rows[:k], curves[:k], strict=True):
            if 2 * len(one & other) > min(len(one), len(other)):
                raise StudyError(f"{curves[k].test.table}: has {len(one & other)} of {len(one)} rows of {curve.test.table}: a test counts once, and "
                                 "cannot predict itself; leave one of them out")
