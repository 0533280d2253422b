"""The appendix of chapter 3: contacts, and what differences from the record come from, tried on bags varied in one thing at a time."""
# SPDX-License-Identifier: GPL-3.0-or-later
from study import StudyError
from study.errors import suggestion
from study.tables import read_words

from . import making
from .bag import GEOTEXTILES, HERE

KEPT = HERE / "kept"
BULGING = ("bulging_seed_1", "bulging_seed_2", "bulging_seed_3")


class Words:
    """A kept table of bags beside one another: table(description, column) is a number."""

    def __init__(self, name):
        self.path = KEPT / f"{name}.tsv"
        self._header, rows = read_words(self.path, ["description"])
        self._rows = {row["description"]: row for _, row in rows}

    def __call__(self, description, column):
        """Raises StudyError for an unknown description or column, or where there is no number."""
        for name, known in ((description, self._rows), (column, self._header)):
            if name not in known:
                raise StudyError(f"{self.path}: has no '{name}'{suggestion(name, known)}")
        try:
            return float(self._rows[description][column])
        except ValueError as error:
            raise StudyError(f"{self.path}: '{description}', {column}: {error}") from error


def span(values, digits=0):
    """Returns "2 to 5" for the least and the greatest of some numbers."""
    return f"{min(values):.{digits}f} to {max(values):.{digits}f}"


def tables(*stems):
    """Returns the kept tables of these names, of both sizes, that are there; each below its name."""
    items = []
    for stem in stems:
        for size, words in (("thesis", "full size"), ("quick", "quick profile")):
            path = KEPT / f"{stem}_{size}.tsv"
            if path.exists():
                items += [f"{stem.replace('_', ' ').capitalize()}, {words}:", path]
    return items


def add(study, runs):
    """Adds the appendix to the page."""
    study.appendix("Contacts of the bag beside those of the representative volume",
                   "The thesis finds the same shapes in its diagrams. Here the greatest difference of cumulative shares (Kolmogorov and "
                   "Smirnov's distance) is set beside the one that two samples of these sizes, drawn from the same soil, exceed with a "
                   "chance of 5 %; for classes, as these are, the chance is smaller still. Samples are grains for the number of contacts, "
                   "contacts for their angle. The representative volume is unloaded until it has about as many contacts a grain as the bag "
                   "is made to. Contacts count as in the thesis, with soil and with the geotextile.",
                   making.spread_table(runs))
    study.appendix("Which of the differences are chance: bags of other representative volumes", volumes(), *tables("seeds", "bulging"))
    study.appendix("What the shape of the sides is worth", sides(study), *tables("causes"))
    study.appendix("What each choice in making and loading the bag is worth", CHOICES, *tables("variants"))
    study.appendix("What the speed of the plates is worth", SPEED, *tables("rates_fast", "rates_held_often", "rates_paced"))


def volumes():
    """Returns what bags of other representative volumes tell."""
    bulging = Words("bulging_thesis")
    axial = [bulging("axial stress at equal tension, PE", bag) for bag in BULGING]
    slope = [bulging("slope of the path in p and q up to the first break, PE", bag) for bag in BULGING]
    return ("The record is of one representative volume, and so is this bag. Three volumes were made into bags of full size, with bulging "
            f"corners. At equal tension their axial stress in PE differs from the recorded one by {span(axial)} %. In axial stress and load "
            "the third is the nearest to their mean, and the study's bag is made of it for that; so it is in part by chance that its "
            "first yarns break where those of the record do, and that the load is the greatest there. Misfits of stresses, of q/p at small "
            "strain and of the strains of the first break and of the greatest stress are within what chance does. Not chance, since all "
            f"bags have it, are the slope of the path of PE ({span(slope, 2)} here), sides that are taut too soon, and how little the void "
            "ratio grows in PP.")


def sides(study):
    """Returns what bags with other sides tell."""
    bulging = Words("bulging_thesis")
    of_bulging = [bulging(f"lateral stress at equal tension, {g}", bag) for g in GEOTEXTILES for bag in BULGING]
    straight = [bulging(f"lateral stress at equal tension, {g}", "bag") for g in GEOTEXTILES]
    share = [bulging("strain of the horizontal yarns of the sides over that of the yarns on the faces at 3 %, PE", bag) for bag in BULGING]
    return ("The sides hold the soil as well, from when they are taut. In the record of PE their horizontal yarns stretch by "
            f"{study.published('side_share_toe_PE')} of what the faces' do at 3 % of strain, and by {study.published('side_share_PE')} at "
            "10 %. How soon they are taut was tried on bags otherwise shaped or filled: it is the corners, of which the thesis says no "
            "more than that they are slightly tightened, and that the bag was drawn from its two cross-sections. Here these hold all along "
            "the sides, and corners have one radius at all heights: rings around the bag have to round them before they are taut. Where "
            f"sides bulge around the corners too (bulging_corners), they stretch by {span(share, 2)} of what the faces do at 3 %; lateral "
            f"stress at equal tension of the faces is then {span(of_bulging)} % larger than recorded, where with straight sides it is larger "
            f"by {span(straight, 1)} %. Corners that are not rounded (sharp_corners) leave the sides slack for too long; rounder ones "
            "(round_corners) draw them taut sooner. Soil that is not stretched to the sides as it grows (unstretched) leaves them slack, but "
            "softens the bag.\n\nFor PP the void ratio grows by less than the recorded one. It is not between the faces that the volume is "
            "missing: there, twice the strain of their yarns less the axial strain is the recorded one. What is left are the sides, whose "
            "bulges Delaunay's tetrahedra take in with all that they span. With half circles for sides (round_sides) the bag loses no void "
            "ratio at first and gains more later, but carries less.")


CHOICES = ("The bag of PE varied in one thing at a time (make ch3-variants): load and stress path under uniaxial compression beside those "
           "of the bag itself. All are compressed slowly enough that inertia is no part of it, but those whose rate is what is varied.\n\n"
           "In the first percents of strain most depends on how dense the soil ends (dense, loose; meshed_evenly, grown_quickly), how far "
           "inside the nodes (nodes_outside, thin_geotextile), how round its sides are and whether it is stretched to them (round_sides, "
           "flatter_sides, unstretched), whether its corners are rounded at all (sharp_corners) and how stiff yarns are at first "
           "(straight_yarns); less on how far corners are rounded, least on the friction of the geotextile. The thesis puts the nodes on "
           "the surface of its bag, and counts voids by the tetrahedra between the soil's centres: its soil ends a node's radius inside "
           "that surface. So made, and with the flat faces of the empty bag, the full-size bag is near the recorded one. How far the soil "
           "is stretched to the bag as it grows is ours to choose (stretched, unstretched): grown alone it leaves the sides slack and is as "
           "soft at first as the recorded bag, but at full size too dense. The bag chosen keeps the thesis's void ratio and is stiffer at "
           "first.")
SPEED = ("Axial stress under fast and slow plates, up to the first station at which a yarn has broken. Under fast plates (fast) the bag "
         "carries less, for two reasons. Where they stop it goes on widening, which unloads its soil: stilled by four times the drag it "
         "carries more (stilled, slow_stilled). And while they move it lags behind them, the less the more often they wait (held_often, "
         "slow_held_often). Left to swing without drag at each station (undragged), grains of a thousandfold density fall short of the load "
         "that they carry at rest; under fast plates (swinging) they are thrown. Still slower plates (slow, slower) change little more.\n\n"
         "The thesis finds the same response at three speeds and does not say in what increments it compresses its bag. Here it depends on "
         "the speed as long as plates go as fast as they are told. Plates that slow down where the unbalanced force would exceed a limit "
         "(way_unbalanced_force: paced, slow_paced) find the same whichever speed they may have, in fewer steps, and break the first yarn "
         "later.")
