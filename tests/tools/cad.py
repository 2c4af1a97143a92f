"""Files of `cageless export`, read by the tools that users have.

OpenCASCADE opens the STEP files, trimesh the STL files and pandas the points. The
surface that they are held against is worked out again here, in NumPy, from Eq. (4) to (7)
of Zhao 2022, the other shapes of docs/theory/geometry.md, the blend of docs/theory/cad.md, the turned section of
docs/theory/space.md and the slot of docs/theory/cad.md.

    python cad.py path/to/cageless path/to/a/scratch/folder
"""

import functools
import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pandas as pd
import trimesh
from pypdf import PdfReader
from OCP.BRep import BRep_Builder, BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepClass import BRepClass_FaceClassifier
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.BRepGProp import BRepGProp
from OCP.BRepTools import BRepTools
from OCP.GeomAbs import GeomAbs_SurfaceType as Kind
from OCP.gp import gp_Pnt, gp_Pnt2d
from OCP.GProp import GProp_GProps
from OCP.IFSelect import IFSelect_ReturnStatus
from OCP.ShapeAnalysis import ShapeAnalysis_ShapeTolerance
from OCP.ShapeFix import ShapeFix_Shape
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_ShapeEnum as Shape
from OCP.TopAbs import TopAbs_State
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS, TopoDS_Compound

from checks import check, exit_code

# Bearing, raceways (span mm, half angle °, centre °, contact angle ° unless 0, shape unless quartic, edge radius and
# depth mm of a slot) and blends in mm that each case is exported with. 6.9 mm by 10° and 4 mm by 40° are near the constraints, Eq. (8) and (9).
PAPER = {}
SLIM = {"outer_ring_outer_radius_mm": 27.9, "outer_ring_width_mm": 7.6}
# Three large balls: the circle of the groove crosses the axis.
THREE = {
    "balls": 3, "ball_radius_mm": 4.0, "inner_groove_bottom_radius_mm": 0.65,
    "outer_groove_bottom_radius_mm": 8.65, "outer_shoulder_radius_mm": 7.0,
    "inner_groove_curvature_radius_mm": 4.2, "outer_groove_curvature_radius_mm": 4.4,
    "outer_ring_outer_radius_mm": 11.0, "outer_ring_width_mm": 10.0,
}  # fmt: skip
LARGE = {
    "balls": 20, "ball_radius_mm": 40.0, "inner_groove_bottom_radius_mm": 220.0,
    "outer_groove_bottom_radius_mm": 300.05, "outer_shoulder_radius_mm": 288.0,
    "inner_groove_curvature_radius_mm": 41.6, "outer_groove_curvature_radius_mm": 42.4,
    "outer_ring_outer_radius_mm": 350.0, "outer_ring_width_mm": 120.0,
}  # fmt: skip
CASES = {
    "conventional": (PAPER, [], [0.5]),
    "structure-d": (PAPER, [(5.1, 25.2, 0.0)], [0.5, 0.0]),
    "two": (PAPER, [(5.1, 25.2, 17.3), (6.0, 12.717, -141.9)], [0.3, 0.0]),
    "touching": (PAPER, [(5.6, 15.774, 171.0), (5.1, 20.0, -153.225_999_99)], [2.0, 0.0]),
    "narrow": (SLIM, [(6.9, 10.0, 90.0)], [0.01, 2.4]),
    "wide": (PAPER, [(4.0, 40.0, -90.0)], [1.0]),
    "three-balls": (THREE, [(4.0, 25.0, 200.0)], [0.5]),
    "large": (LARGE, [(42.0, 20.0, -33.3)], [0.0, 10.0]),
    "angular-contact": ({"contact_angle_deg": 15.0}, [], [0.5]),
    "turned": ({"contact_angle_deg": 15.0}, [(5.1, 25.2, 0.0, 15.0)], [0.5, 0.0]),
    "ellipse": (PAPER, [(5.1, 25.2, 17.3, 0.0, "ellipse")], [1.0]),
    "shuttle": (PAPER, [(5.1, 25.2, 17.3, 0.0, "shuttle")], [0.5, 0.0]),
    "steady": (PAPER, [(5.0, 25.2, 17.3, 0.0, "steady"), (4.0, 35.0, -100.0, 0.0, "steady")], [0.5, 0.0]),
    "turned-back": (PAPER, [(5.1, 25.2, 17.3, -4.0), (6.0, 12.717, -141.9, -4.0)], [0.3]),
    "turned-three-balls": (THREE, [(4.0, 25.0, 200.0, 10.0)], [0.5]),
    "slot": (PAPER, [(2.4, 25.2, 17.3, 0.0, "slot", 0.3)], [0.0]),
    "slots": (PAPER, [(5.1, 25.2, 17.3, 0.0, "slot", 0.3, 1.5), (1.9, 12.0, 60.0, 0.0, "slot", 0.5)], [0.0]),
    "round-slot": (PAPER, [(2.4, 2.632_305_24, -141.9, 0.0, "slot", 0.3)], [0.0]),
    "turned-slot": ({"contact_angle_deg": 15.0}, [(2.4, 25.2, 100.0, 15.0, "slot", 0.3)], [0.0]),
    "slot-and-path": (PAPER, [(2.4, 20.0, 0.0, 0.0, "slot", 0.3), (5.1, 25.2, 120.0)], [0.5]),
    "slot-three-balls": (THREE, [(2.0, 25.0, 200.0, 0.0, "slot", 0.2)], [0.0]),
}


def below(what, found, allowed):
    worst = float(np.max(np.abs(found), initial=0.0))
    check(what, worst <= allowed, f"({worst:.3e}, allowed {allowed:.1e})")


class Slot:
    """A slot in the analytic ring, by the line of the centres of its rounded edges."""

    def __init__(self, ring, span, theta, middle, edge, depth):
        self.ring, self.theta, self.middle, self.edge = ring, theta, middle, edge
        sine = span / (2 * ring.rw)
        self.half = (ring.rw + edge) * sine
        self.reach = ring.re + edge
        sink = np.sqrt(self.reach**2 - self.half**2) - (ring.rw + edge) * np.sqrt(1 - sine**2) - ring.back
        self.floor = ring.re + (2 * edge + sink if depth is None else depth)
        self.straight = theta - self.half / ring.ro
        # An end is 1 or -1 along psi, a straight edge 1 or -1 towards +z.
        self.stretches = [("end", 1, np.pi / 2), ("end", -1, np.pi / 2)]
        if self.straight > 1e-9:
            self.stretches += [("straight", 1, self.straight), ("straight", -1, self.straight)]

    def place(self, stretch, t):
        """Angle from the middle, and distance from the axis of the section."""
        kind, way, _ = stretch
        if kind == "end":
            return way * (self.straight + self.half / self.ring.ro * np.cos(t)), self.half * np.sin(t)
        return t, way * self.half + 0 * t

    def in_space(self, local, along, across):
        """Point in the section at an angle, along its axis from the centre of the groove and across it."""
        sin, cos = np.sin(self.ring.turn), np.cos(self.ring.turn)
        rho = self.ring.groove_centre[0] + along * cos - across * sin
        psi = self.middle + local
        z = self.ring.groove_centre[1] + along * sin + across * cos
        return np.stack(np.broadcast_arrays(rho * np.sin(psi), -rho * np.cos(psi), z), axis=-1)

    def section(self, points):
        """Along and across, in the section through each point."""
        sin, cos = np.sin(self.ring.turn), np.cos(self.ring.turn)
        out = np.hypot(points[..., 0], points[..., 1]) - self.ring.groove_centre[0]
        up = points[..., 2] - self.ring.groove_centre[1]
        return out * cos + up * sin, up * cos - out * sin

    def centres(self, stretch, t):
        local, across = self.place(stretch, t)
        return self.in_space(local, np.sqrt(self.reach**2 - across**2), across)

    def mill(self, stretch, t):
        kind, way, _ = stretch
        at = way * self.straight + 0 * t if kind == "end" else t
        return self.in_space(at, 1.0, 0.0) - self.in_space(at, 0.0, 0.0)

    def surface(self, stretch, t, share):
        """Points of the rounded edge for shares up to 1, of the wall from there to 2."""
        local, across = self.place(stretch, t)
        centre, mill = self.centres(stretch, t), self.mill(stretch, t)
        groove = (self.in_space(local, 0 * t, 0 * t) - centre) / self.reach
        h = 1e-5
        line = (self.centres(stretch, t + h) - self.centres(stretch, t - h)) / (2 * h)
        inside = np.cross(groove, line)
        inside *= (stretch[1] if stretch[0] == "straight" else -stretch[1]) / np.linalg.norm(inside, axis=-1)[..., None]
        whole = np.arctan2(-np.sum(groove * mill, axis=-1), np.sum(inside * mill, axis=-1))
        angle = (np.minimum(share, 1) * whole)[..., None]
        top = centre + self.edge * (np.cos(angle) * groove + np.sin(angle) * inside)
        length = 0 * t
        for _ in range(10):
            length = length + self.floor - self.section(top + length[..., None] * mill)[0]
        return top + (np.maximum(share - 1, 0) * length)[..., None] * mill

    def to_line(self, points, along_mill=False):
        """Least distance of each point from the line of centres, or from it as the mill sees it."""
        least = np.full(len(points), np.inf)
        for stretch in self.stretches:

            def off(t):
                away = points - self.centres(stretch, t)
                if along_mill:
                    mill = self.mill(stretch, t)
                    away = away - np.sum(away * mill, axis=-1)[:, None] * mill
                return np.linalg.norm(away, axis=-1)

            t = np.linspace(-stretch[2], stretch[2], 200)
            best = t[np.argmin([off(np.full(1, one)) for one in t], axis=0)]
            low, high = best - (t[1] - t[0]), best + (t[1] - t[0])
            for _ in range(26):
                third = (high - low) / 3
                left = off(low + third) < off(high - third)
                low, high = np.where(left, low, low + third), np.where(left, high - third, high)
            least = np.minimum(least, off(np.clip((low + high) / 2, -stretch[2], stretch[2])))
        return least

    def distance(self, points):
        """Distance of points from the nearest of edge, wall and floor."""
        edge = self.to_line(points) - self.edge
        wall = self.to_line(points, True) - self.edge
        return np.min(np.abs([edge, wall, self.section(points)[0] - self.floor]), axis=0)

    def near(self, points, within):
        """Whether points lie as far in the plan as the slot does, give or take."""
        psi = np.arctan2(points[:, 0], -points[:, 1])
        local = np.abs((psi - self.middle + np.pi) % (2 * np.pi) - np.pi)
        end = np.clip((local - self.straight) * self.ring.ro / self.half, 0, 1)
        across = np.abs(self.section(points)[1]) * self.reach / self.ring.re
        return (local < self.theta + within) & (across < self.half * np.sqrt(1 - end**2) + within)

    def random_points(self, count, generator):
        points = []
        for stretch in self.stretches:
            t = stretch[2] * generator.uniform(-1, 1, count)
            points.append(self.surface(stretch, t, generator.uniform(0, 2, count)))
        width = generator.uniform(-1, 1, count) * (self.half - self.edge)
        points.append(self.in_space(self.straight * generator.uniform(-1, 1, count), self.floor, width))
        return np.concatenate(points)

    def volume(self):
        """Of a closed surface of triangles, extrapolated from two numbers of them."""
        found = []
        for count in (100, 200):
            u = np.linspace(0, 1, count + 1)
            total = 0.0
            for stretch in self.stretches:
                kind, way, end = stretch
                t = end * (2 * u - 1)
                rows = [self.surface(stretch, t, np.full(len(t), share)) for share in u]
                rows.append(self.surface(stretch, t, np.full(len(t), 2.0)))
                # Floor and groove up to the axis of the section.
                local, across = self.place(stretch, t)
                foot, rim = self.section(rows[-1])[1], across * self.ring.re / self.reach
                turn = np.arctan2(rows[-1][:, 0], -rows[-1][:, 1]) - self.middle
                turn = (turn + np.pi) % (2 * np.pi) - np.pi
                rows += [self.in_space(turn, self.floor, foot * (1 - share)) for share in u[1:]]
                bottom = [self.in_space(local, np.sqrt(self.ring.re**2 - (rim * share) ** 2), rim * share) for share in u]
                grid = np.array(bottom + rows[1:])
                a, b, c, d = grid[:-1, :-1], grid[:-1, 1:], grid[1:, 1:], grid[1:, :-1]
                six = np.sum(a * (np.cross(b, c) + np.cross(c, d)))
                total += six / 6 * (-way if kind == "straight" else way)
            found.append(total)
        return (4 * found[1] - found[0]) / 3

    def balls_next_to_rest(self, count, generator):
        """Centres of balls that press the edges by micrometres, and how far they are from them."""
        ring = self.ring
        local = self.theta * generator.uniform(-0.99, 0.99, count)
        end = np.maximum(np.abs(local) - self.straight, 0) * ring.ro / self.half
        across = self.half * np.sqrt(1 - end**2)
        rest = np.sqrt(self.reach**2 - across**2) - np.sqrt((ring.rw + self.edge) ** 2 - across**2)
        towards = generator.uniform(-np.pi / 2, np.pi / 2, count)
        balls = self.in_space(local, rest + 0.008 * np.cos(towards), 0.008 * np.sin(towards))
        return balls, self.to_line(balls) - self.edge


class Ring:
    """The analytic outer ring in millimetres and radians."""

    def __init__(self, case, blend):
        b = case["bearing"]
        self.rw, self.ro = b["ball_radius_mm"], b["outer_groove_bottom_radius_mm"]
        self.re, self.ros = b["outer_groove_curvature_radius_mm"], b["outer_shoulder_radius_mm"]
        self.outer, self.width = b["outer_ring_outer_radius_mm"], b["outer_ring_width_mm"]
        # A free contact angle opens the grooves about the pitch circle and offsets them.
        free = np.radians(b.get("contact_angle_deg", 0.0))
        room = self.re + b["inner_groove_curvature_radius_mm"] - 2 * self.rw
        self.ro += room * (1 - np.cos(free)) / 2
        self.t = self.ro - self.rw
        self.blend = blend
        raceways = case.get("raceway", [])
        raceways = raceways if isinstance(raceways, list) else [raceways]
        sections = raceways
        raceways = [r for r in sections if r.get("shape") != "slot"]
        self.raceways = [
            (r["axial_span_mm"], np.radians(r["half_angle_deg"]), np.radians(r.get("centre_angle_deg", 0.0)))
            for r in raceways
        ]  # fmt: skip
        self.shapes = [r.get("shape", "quartic") for r in raceways]
        self.back = self.re - self.rw
        self.turn = np.radians(sections[0].get("contact_angle_deg", 0.0)) if sections else free
        self.groove_centre = (self.ro - self.re, -room * np.sin(free) / 2)
        self.slots = [
            Slot(
                self, r["axial_span_mm"], np.radians(r["half_angle_deg"]), np.radians(r["centre_angle_deg"]),
                r["edge_radius_mm"], r.get("slot_depth_mm"),
            )
            for r in sections if r.get("shape") == "slot"
        ]  # fmt: skip
        # The ball that rests in the groove, whose centre is Re from its bottom.
        self.ball = (
            self.ro - self.re + self.back * np.cos(self.turn),
            -room * np.sin(free) / 2 + self.back * np.sin(self.turn),
        )

    def flank_angle(self, shape, span, theta, psi):
        """Angle of the flanks of a shape at |psi| <= theta."""
        if shape == "quartic":
            return self.path_angle(span, theta, psi)
        u, middle = np.abs(psi) / theta, np.arcsin(span / (2 * self.rw))
        if shape != "steady":
            return middle * (1 - u**2) ** {"ellipse": 0.5, "shuttle": 1.0}[shape]
        # The logarithm of the speed: its slope grows up to 0.35, and ceases from 0.9 on.
        grows, ceases = np.minimum(u, 0.35), np.maximum(u - 0.9, 0)
        lost = 0.775 - grows**2 / 0.7 - np.maximum(u - 0.35, 0) + ceases**2 / 0.2
        speed = (2 * np.cos(middle) / (1 + np.cos(middle))) ** (lost / 0.775)
        # 1 - cos of it, which keeps its digits near the ends.
        versine = 2 * -np.expm1(np.log(speed)) / (2 - speed)
        return 2 * np.arcsin(np.sqrt(np.maximum(versine, 0) / 2))

    def path_angle(self, span, theta, psi):
        """Contact angle of Eq. (4) to (6) at |psi| <= theta, by Newton's method for x."""
        ro, sin, cos = self.ro, np.sin(theta), np.cos(theta)
        c = -(self.t + np.sqrt(self.rw**2 - span**2 / 4))
        rise = ro * sin * np.tan(theta)
        a = (rise + 2 * ro * cos + 2 * c) / (2 * ro**4 * sin**4)
        b = -(4 * c + rise + 4 * ro * cos) / (2 * ro**2 * sin**2)
        psi = np.abs(psi)
        x = ro * np.sin(psi)
        for _ in range(8):
            ahead = x * np.cos(psi) + (a * x**4 + b * x**2 + c) * np.sin(psi)
            x = x - ahead / (np.cos(psi) + (4 * a * x**3 + 2 * b * x) * np.sin(psi))
        r = np.hypot(x, a * x**4 + b * x**2 + c) - self.t
        return np.arctan2(np.sqrt(np.maximum(self.rw**2 - r**2, 0)), r)

    def contact_angle(self, psi):
        """Contact angle all round, blended."""
        angle = np.zeros_like(psi)
        for shape, (span, theta, centre) in zip(self.shapes, self.raceways, strict=True):
            local = np.abs((psi - centre + np.pi) % (2 * np.pi) - np.pi)
            inside = local < theta
            angle[inside] = self.flank_angle(shape, span, theta, local[inside])
            length = self.blend / self.ro
            if length == 0:
                continue
            start = theta - length
            # Value, slope and curvature there, by a polynomial through its surroundings;
            # one side of it lies within the blend, where the path is smooth as well.
            at = np.linspace(-0.8, 0.8, 17) / (1 if shape == "quartic" else 8)
            fit = np.polynomial.Polynomial.fit(at, self.flank_angle(shape, span, theta, start + at * length), 10)
            value, slope, bend = fit(0.0), fit.deriv()(0.0), fit.deriv(2)(0.0)
            t = (local - start) / length
            within = inside & (t > 0)
            t = t[within]
            angle[within] = (1 - t) ** 3 * (
                value + (3 * value + slope) * t + (6 * value + 3 * slope + bend / 2) * t**2
            )
        return angle

    def centre(self, psi, side):
        """Radius and height of the centre of a flank, side 1 towards +z and -1 towards -z."""
        towards = self.turn + side * self.contact_angle(psi)
        return self.ball[0] - self.back * np.cos(towards), self.ball[1] - self.back * np.sin(towards)

    def flank(self, psi, z, side):
        radius, height = self.centre(psi, side)
        return radius + np.sqrt(self.re**2 - (z - height) ** 2)

    def groove(self, psi, z):
        """Radius of the groove."""
        return np.minimum(self.flank(psi, z, 1), self.flank(psi, z, -1))

    def ridge(self, psi):
        """Height at which the flanks meet."""
        angle = self.contact_angle(psi)
        depth = np.sqrt(self.re**2 - (self.back * np.sin(angle)) ** 2) - self.back * np.cos(angle)
        return self.ball[1] + depth * np.sin(self.turn)

    def groove_distance(self, points):
        """Distance from the groove, along the radius foreshortened by its slope."""
        psi, rho = np.arctan2(points[:, 0], -points[:, 1]), np.hypot(points[:, 0], points[:, 1])
        n = self.normal(psi, points[:, 2], np.where(points[:, 2] < self.ridge(psi), -1, 1))
        out = -n[:, 0] * np.sin(psi) + n[:, 1] * np.cos(psi)
        return (rho - self.groove(psi, points[:, 2])) * np.abs(out)

    def distance(self, points):
        """Distance from the groove or, around a slot, from the nearest of its faces and the groove."""
        off = np.abs(self.groove_distance(points))
        for slot in self.slots:
            near = slot.near(points, 0.01)
            off[near] = np.minimum(off[near], slot.distance(points[near]))
        return off

    def normal(self, psi, z, side):
        """Normal of a flank out of the material, by differences."""
        h, k = 1e-6, 1e-5 * side
        rho = self.flank(psi, z, side)
        along = (self.flank(psi + h, z, side) - self.flank(psi - h, z, side)) / (2 * h) / rho
        across = (-3 * rho + 4 * self.flank(psi, z + k, side) - self.flank(psi, z + 2 * k, side)) / (2 * k)
        e = np.stack([np.sin(psi), -np.cos(psi), 0 * psi], axis=1)
        t = np.stack([np.cos(psi), np.sin(psi), 0 * psi], axis=1)
        n = -e + along[:, None] * t + across[:, None] * np.array([0.0, 0.0, 1.0])
        return n / np.linalg.norm(n, axis=1)[:, None]

    def random_points(self, count, generator):
        """On the groove, half of them where the raceways are."""
        psi = generator.uniform(-np.pi, np.pi, count)
        for k, (_, theta, centre) in enumerate(self.raceways):
            part = slice(k * count // 2 // len(self.raceways), (k + 1) * count // 2 // len(self.raceways))
            psi[part] = centre + theta * generator.uniform(-1.05, 1.05, len(psi[part]))
        ends = []
        for side in (-1, 1):
            radius, height = self.centre(psi, side)
            ends.append(height + side * np.sqrt(self.re**2 - (self.ros - radius) ** 2))
        z = ends[0] + (ends[1] - ends[0]) * generator.uniform(0, 1, count)
        rho = self.groove(psi, z)
        points = np.stack([rho * np.sin(psi), -rho * np.cos(psi), z], axis=1)
        for slot in self.slots:
            points = points[~slot.near(points, 1e-6)]
        return np.concatenate([points, *(slot.random_points(count // 5, generator) for slot in self.slots)])

    def balls_next_to_rest(self, count, generator):
        """Centres of balls that press the middle of each raceway by micrometres, and how far they
        are from its flanks."""
        psi = []
        for _, theta, centre in self.raceways:
            within = 0.8 * (theta - self.blend / self.ro)
            psi.append(centre + within * generator.uniform(-1, 1, count // len(self.raceways)))
        psi = (np.concatenate([*psi, []]) + np.pi) % (2 * np.pi) - np.pi
        towards = self.turn + generator.uniform(-np.pi / 2, np.pi / 2, len(psi))
        rho, z = self.ball[0] + 0.008 * np.cos(towards), self.ball[1] + 0.008 * np.sin(towards)
        beyond = []
        for side in (-1, 1):
            radius, height = self.centre(psi, side)
            beyond.append(np.hypot(rho - radius, z - height))
        balls = [(np.stack([rho * np.sin(psi), -rho * np.cos(psi), z], axis=1), self.re - np.maximum(*beyond))]
        balls += [slot.balls_next_to_rest(count, generator) for slot in self.slots]
        return np.concatenate([b for b, _ in balls]), np.concatenate([d for _, d in balls])

    @functools.cache
    def volume(self):
        """By the trapezium rule over z within Gauss over each smooth stretch of psi."""
        cuts = [np.array([-np.pi, np.pi])]
        length = self.blend / self.ro
        for _, theta, centre in self.raceways:
            cuts.append(centre + np.array([-theta, -theta + length, theta - length, theta]))
            cuts.append(centre + theta * np.array([-0.9, -0.35, 0.35, 0.9]))
        cuts = np.unique((np.concatenate(cuts) + np.pi) % (2 * np.pi) - np.pi)
        cuts = np.append(cuts[cuts < np.pi], np.pi)
        nodes, weights = np.polynomial.legendre.leggauss(60)
        # In η, so that the arc is smooth; from the ridge to the shoulder.
        u, w = np.polynomial.legendre.leggauss(40)
        total = 0.0
        for start, end in zip(cuts, cuts[1:]):
            psi = (start + end) / 2 + (end - start) / 2 * nodes
            section = (self.outer**2 - self.ros**2) * self.width / 2
            for side in (-1, 1):
                radius, height = (v[:, None] for v in self.centre(psi, side))
                up = np.arcsin(self.back * np.sin(self.contact_angle(psi)) / self.re)[:, None]
                low, high = up + side * self.turn, np.arccos((self.ros - radius) / self.re)
                eta = low + (high - low) * (u + 1) / 2
                rho, dz = radius + self.re * np.cos(eta), self.re * np.cos(eta) * (high - low) / 2
                section = section - np.sum(w * (rho**2 - self.ros**2) * dz, axis=1) / 2
            total += np.sum(weights * section) * (end - start) / 2
        return total - sum(slot.volume() for slot in self.slots)


def case_file(binary, path, bearing, raceways):
    text = subprocess.run([binary, "new", "--conventional"], check=True, capture_output=True, text=True).stdout
    for key, value in bearing.items():
        if key == "contact_angle_deg":
            text = text.replace("[bearing]", f"[bearing]\n{key} = {value}")
            continue
        lines = [line for line in text.splitlines() if line.startswith(f"{key} = ")]
        assert len(lines) == 1, key
        text = text.replace(lines[0], f"{key} = {value}")
    for span, angle, centre, *more in raceways:
        text += f"\n[[raceway]]\naxial_span_mm = {span}\nhalf_angle_deg = {angle}\ncentre_angle_deg = {centre}\n"
        text += "".join(f"contact_angle_deg = {angle}\n" for angle in more[:1])
        text += "".join(f'shape = "{shape}"\n' for shape in more[1:2])
        text += "".join(f"{key} = {mm}\n" for key, mm in zip(("edge_radius_mm", "slot_depth_mm"), more[2:]))
    path.write_text(text)
    return tomllib.loads(text)


def export(binary, case, out, *more):
    command = [binary, "export", case, "--format", out.suffix[1:], "--out", out, "--json", *more]
    ended = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if ended.returncode or ended.stderr:
        raise RuntimeError(f"exit code {ended.returncode} of {command}: {ended.stderr}")
    return json.loads(ended.stdout)


def explore(shape, kind):
    found, explorer = [], TopExp_Explorer(shape, kind)
    while explorer.More():
        found.append(explorer.Current())
        explorer.Next()
    return found


def face_points(face, count, generator):
    """Random points of a face within its bounds."""
    surface = BRepAdaptor_Surface(face)
    classifier = BRepClass_FaceClassifier()
    u0, u1, v0, v1 = BRepTools.UVBounds_s(face)
    points = []
    for _ in range(20 * count):
        u, v = generator.uniform(u0, u1), generator.uniform(v0, v1)
        classifier.Perform(face, gp_Pnt2d(u, v), 1e-9)
        if classifier.State() == TopAbs_State.TopAbs_IN:
            p = surface.Value(u, v)
            points.append([p.X(), p.Y(), p.Z()])
            if len(points) == count:
                break
    return np.array(points)


def step(name, path, said, ring, generator):
    reader = STEPControl_Reader()
    check(f"{name}: read", reader.ReadFile(str(path)) == IFSelect_ReturnStatus.IFSelect_RetDone)
    check(f"{name}: one root", reader.NbRootsForTransfer() == 1 and reader.TransferRoots() == 1)
    troubles = reader.WS().TransferReader().TransientProcess().CheckList(False)
    check(f"{name}: transferred without a word", troubles.IsEmpty(False))
    solid = reader.OneShape()
    check(f"{name}: a solid", solid.ShapeType() == Shape.TopAbs_SOLID)
    shells = explore(solid, Shape.TopAbs_SHELL)
    check(f"{name}: one closed shell", len(shells) == 1 and BRep_Tool.IsClosed_s(shells[0]))
    check(f"{name}: valid", BRepCheck_Analyzer(solid, True).IsValid())
    check(f"{name}: nothing to heal", not ShapeFix_Shape(solid).Perform())
    below(f"{name}: tolerances in mm", ShapeAnalysis_ShapeTolerance().Tolerance(solid, 1), 1e-5)

    analytic = ring.volume()
    below(f"{name}: stated volume", said["volume_mm3"] / analytic - 1, 1e-9 if ring.slots else 1e-10)
    for way in ("GK", "default"):
        props = GProp_GProps()
        if way == "GK":
            BRepGProp.VolumePropertiesGK_s(solid, props, 1e-9, True, True)
        else:
            BRepGProp.VolumeProperties_s(solid, props)
        below(f"{name}: volume ({way})", props.Mass() / analytic - 1, 1e-6)

    faces = [TopoDS.Face(face) for face in explore(solid, Shape.TopAbs_FACE)]
    check(f"{name}: faces", len(faces) == said["faces"], len(faces))
    kinds = [BRepAdaptor_Surface(face).GetType() for face in faces]
    check(f"{name}: B-spline faces", kinds.count(Kind.GeomAbs_BSplineSurface) == said["bspline_faces"])

    def outside(points):
        rho = np.hypot(points[:, 0], points[:, 1])
        return np.min(np.abs([rho - ring.outer, rho - ring.ros, np.abs(points[:, 2]) - ring.width / 2]), axis=0)

    others = [f for f in faces if np.max(outside(face_points(f, 20, generator))) < 1e-6]
    grooves = [f for f in faces if f not in others]
    for face in others:
        below(f"{name}: other faces", outside(face_points(face, 20, generator)), 1e-9)
    each = 1000 // len(grooves) + 1
    points = np.concatenate([face_points(face, each, generator) for face in grooves])
    check(f"{name}: a thousand points", len(points) >= 1000, len(points))
    off = ring.distance(points)
    below(f"{name}: groove faces against the surface, mm", off, 1e-4)
    below(f"{name}: and against the stated deviation", off, said["deviation_um"] * 1.1e-3 + 1e-9)

    # The other way round: points of the analytic surface lie on the shell of groove faces.
    groove, builder = TopoDS_Compound(), BRep_Builder()
    builder.MakeCompound(groove)
    for face in grooves:
        builder.Add(groove, face)
    distances = [
        BRepExtrema_DistShapeShape(BRepBuilderAPI_MakeVertex(gp_Pnt(*p)).Vertex(), groove).Value()
        for p in ring.random_points(120, generator)
    ]
    below(f"{name}: the surface against the faces, mm", distances, 1e-4)
    if ring.raceways or ring.slots:
        centres, expected = ring.balls_next_to_rest(80, generator)
        felt = [
            BRepExtrema_DistShapeShape(BRepBuilderAPI_MakeVertex(gp_Pnt(*c)).Vertex(), groove).Value()
            for c in centres
        ]
        below(f"{name}: balls felt, mm", felt - expected, 2e-5)


def title(binary, case, out):
    """A title that looks like the end of an entity is read as it was written."""
    meant = "Ring ');  it's θ (a','b)"
    export(binary, case, out, "--set", f"title={json.dumps(meant, ensure_ascii=False)}")
    reader = STEPControl_Reader()
    reader.ReadFile(str(out))
    model = reader.StepModel()
    entities = range(1, model.NbEntities() + 1)
    check("title: no errors of syntax", not any(model.IsErrorEntity(k) for k in entities))
    kinds = {k: model.Entity(k).DynamicType().Name() for k in entities}
    names = [model.Entity(k).Id() for k, kind in kinds.items() if kind == "StepBasic_Product"]
    check("title: read", [n and n.ToCString() for n in names] == [meant], str(names))


def drawing(binary, case, out):
    """The drawing of a sheet, by a reader of PDF and one of XML: its size, its texts, its circles in their scale."""
    command = [binary, "sheet", case, "--without-benefit", "--quiet", "--out", out]
    subprocess.run([str(c) for c in command], check=True, capture_output=True)
    document = PdfReader(out / "drawing.pdf", strict=True)
    check("drawing: one page", len(document.pages) == 1)
    page = document.pages[0]
    size = [float(length) * 25.4 / 72 for length in page.mediabox[2:]]
    check("drawing: A4 across", np.allclose(size, [297, 210], atol=0.01), str(size))
    svg = ElementTree.parse(out / "drawing.svg").getroot()
    tag = "{http://www.w3.org/2000/svg}"
    texts = [each.text for each in svg.iter(f"{tag}text")]
    read = page.extract_text()
    missing = [text for text in texts if not set("θψβα") & set(text) and text.split()[0] not in read]
    check("drawing: the PDF has the texts of the SVG", not missing, str(missing))
    check("drawing: diameter", "Ø 62" in texts and "Ø 62" in read)
    arcs = [re.match(r"M.*?A([0-9.]+) ", each.get("d")) for each in svg.iter(f"{tag}path")]
    radii = {round(float(arc[1]), 6) for arc in arcs if arc}
    # At the scale 1 : 1.
    check("drawing: circles", {31.0, 26.0, 27.765} <= radii, str(sorted(radii)))


def stl(name, path, said, ring, generator):
    mesh = trimesh.load(path)
    check(f"{name}: watertight", mesh.is_watertight)
    check(f"{name}: wound consistently", mesh.is_winding_consistent)
    check(f"{name}: a ring", mesh.euler_number == 0)
    check(f"{name}: triangles", len(mesh.faces) == said["triangles"])
    check(f"{name}: corners", len(mesh.vertices) == said["vertices"], len(mesh.vertices))
    chord = 1e-3 * said["chord_um"]
    below(f"{name}: stated deviation", said["deviation_um"] * 1e-3, chord)
    check(f"{name}: normals outwards", mesh.volume > 0)
    below(f"{name}: volume", mesh.volume - ring.volume(), mesh.area * chord)
    below(f"{name}: stated mesh volume", mesh.volume / said["mesh_volume_mm3"] - 1, 1e-6)
    # Normals as stored, not as trimesh works them out again.
    stored = np.frombuffer(path.read_bytes()[84:], dtype=np.dtype([("n", "<f4", 3), ("v", "<f4", (3, 3)), ("a", "<u2")]))
    corners = stored["v"].astype(float)
    n = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    n /= np.linalg.norm(n, axis=1)[:, None]
    below(f"{name}: stored normals", n - stored["n"], 1e-6)
    # Points within triangles, on the groove and on the cylinder outside.
    share = generator.dirichlet([1, 1, 1], len(corners))
    points = np.einsum("tk,tkc->tc", share, corners)
    e = points[:, :2] / np.linalg.norm(points[:, :2], axis=1)[:, None]
    inward = np.einsum("tc,tc->t", n[:, :2], e) < -1e-3
    groove = inward & (np.linalg.norm(corners[:, :, :2], axis=2).max(axis=1) > ring.ros + 1e-4)
    below(f"{name}: groove", ring.distance(points[groove]), chord)
    outside = np.einsum("tc,tc->t", n[:, :2], e) > 0.5
    below(f"{name}: outside", np.linalg.norm(points[outside, :2], axis=1) - ring.outer, chord)


def points(name, path, said, ring):
    table = pd.read_csv(path, float_precision="round_trip")
    kinds = table.pop("kind").to_numpy()
    table = {key: column.to_numpy(float) for key, column in table.items()}
    check(f"{name}: kinds", set(kinds) == {"contact", "surface", *(["edge", "wall", "floor"] if ring.slots else [])})
    check(f"{name}: rows of contact", np.count_nonzero(kinds == "contact") == said["contact_points"])
    check(f"{name}: rows of surface", np.count_nonzero(kinds != "contact") == said["surface_points"])
    p = np.stack([table[f"{c}_mm"] for c in "xyz"], axis=1)
    n = np.stack([table[f"n{c}"] for c in "xyz"], axis=1)
    psi, eta, side = np.radians(table["psi_deg"]), np.radians(table["eta_deg"]), table["side"]
    below(f"{name}: unit normals", np.linalg.norm(n, axis=1) - 1, 1e-11)
    rho = np.hypot(p[:, 0], p[:, 1])
    below(f"{name}: psi", p[:, :2] - rho[:, None] * np.stack([np.sin(psi), -np.cos(psi)], axis=1), 1e-8)
    inside = np.full(len(psi), False)
    for slot in ring.slots:
        inside |= slot.near(p, -1e-6)
    touch = kinds == "contact"
    groove = ((kinds == "surface") | touch) & ~inside
    beyond = ((p[:, 2] - ring.ridge(psi)) * side)[groove]
    check(f"{name}: sides", np.all(beyond >= -1e-8) and np.all(np.abs(side) == 1))
    below(f"{name}: on the surface, mm", ring.distance(p), 5e-8 + 1e-3 * said["deviation_um"])
    # Normals are orthogonal to the surface; where ends of raceways have a kink there are two.
    smooth = groove.copy()
    for _, theta, centre in ring.raceways:
        local = np.abs((psi - centre + np.pi) % (2 * np.pi) - np.pi)
        smooth &= (np.abs(local - theta) > 1e-4 * theta) | (ring.blend > 0)
    below(f"{name}: normals", (ring.normal(psi, p[:, 2], side) - n)[smooth], 3e-6)
    for slot in ring.slots:
        for kind in ("edge", "wall", "floor"):
            one = (kinds == kind) & slot.near(p, 0.01)
            off = slot.distance(p[one] + 1e-3 * n[one])
            # At the foot of a wall one face is less far from its neighbour.
            below(f"{name}: normals of {kind}", np.maximum(off - 1e-3, 0), 1e-6)
            check(f"{name}: {kind} leaves its faces", np.quantile(off, 0.75) > 0.999e-3)
        one = touch & slot.near(p, -1e-6)
        local = (psi[one] - slot.middle + np.pi) % (2 * np.pi) - np.pi
        straight = np.abs(local) < slot.straight
        check(f"{name}: contacts in the slot", np.count_nonzero(straight) > 1 or slot.straight < 1e-3)
        angle = np.arcsin(slot.half / (ring.rw + slot.edge))
        below(f"{name}: contacts of the slot", (eta - ring.turn - side * angle)[one][straight], 1e-7)
    # At an end without blend, rounding of r to 4e-15 mm is 2e-7 mm of z here.
    # The contact track: balls that rest in the groove touch there, at plus and minus alpha.
    contact = touch & ~inside
    angle = ring.turn + side[contact] * ring.contact_angle(psi[contact])
    below(f"{name}: contact angle", eta[contact] - angle, 1e-7)
    radius = ring.ball[0] + ring.rw * np.cos(angle)
    below(f"{name}: contact radius", rho[contact] - radius, 5e-8 + 5e-7 * abs(np.sin(ring.turn)))
    below(f"{name}: contact height", p[contact, 2] - ring.ball[1] - ring.rw * np.sin(angle), 5e-7)
    e = np.stack([np.sin(psi), -np.cos(psi), 0 * psi], axis=1)[contact]
    ball = ring.ball[0] * e + ring.ball[1] * np.array([0.0, 0.0, 1.0]) - p[contact]
    t = np.stack([np.cos(psi), np.sin(psi), 0 * psi], axis=1)[contact]
    flat = n[contact] - np.einsum("pc,pc->p", n[contact], t)[:, None] * t
    cosine = np.einsum("pc,pc->p", flat, ball) / np.linalg.norm(flat, axis=1) / ring.rw
    below(f"{name}: normals point at the ball's centre", cosine - 1, 1e-9)
    for one in (-1, 1):
        track = psi[touch & (side == one)]
        steps = np.append(np.diff(track), track[0] + 2 * np.pi - track[-1])
        check(f"{name}: the track ascends", np.all(steps > 0))
        below(f"{name}: spacing", steps * ring.ro, said["spacing_mm"] * (1 + 1e-9))
    for span, theta, centre in ring.raceways:
        local = np.abs((psi - centre + np.pi) % (2 * np.pi) - np.pi)
        nearest = np.argmin(np.where(contact, local, np.inf))
        apart = (p[nearest, 2] - ring.ball[1]) * np.cos(ring.turn) - (rho[nearest] - ring.ball[0]) * np.sin(ring.turn)
        below(f"{name}: span in the middle", 2 * np.abs(apart) - span, 0.01 * span)


def measured(name, binary, case, path, ring, generator):
    """Points of the solid with errors of 1 µm give the raceways back by `cageless measure`."""
    reader = STEPControl_Reader()
    reader.ReadFile(str(path))
    reader.TransferRoots()
    faces = [TopoDS.Face(face) for face in explore(reader.OneShape(), Shape.TopAbs_FACE)]
    grooves = [f for f in faces if BRepAdaptor_Surface(f).GetType() == Kind.GeomAbs_BSplineSurface]
    points = np.concatenate([face_points(face, 2000, generator) for face in grooves])
    points += generator.normal(0.0, 1e-3, points.shape)
    touched = path.with_suffix(".points.csv")
    np.savetxt(touched, points, delimiter=",", header="x_mm,y_mm,z_mm", comments="", fmt="%.7f")
    out = path.with_suffix(".measured")
    command = [str(c) for c in (binary, "measure", case, touched, "--json", "--out", out)]
    found = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["raceways"]
    entered = tomllib.loads((out / "measured.toml").read_text())["raceway"]
    check(f"{name}: every raceway", len(found) == len(entered) == len(ring.raceways))
    for said, raceway, (_, theta, centre) in zip(found, entered, ring.raceways, strict=True):
        check(f"{name}: points", said["measured_points"] > 2000, said["measured_points"])
        below(f"{name}: deviation, µm", said["measured_deviation_um"] - 1.0, 0.05)
        psi, angle = np.radians(raceway["profile"]).T
        designed = ring.contact_angle(centre + psi)
        below(f"{name}: flank angle, °", np.degrees(angle - designed), 0.15)
        # ψ = θ sin t with t in equal steps; a ball lags by the integral of (1/cos α − 1)/2.
        t = np.linspace(0, np.pi / 2, len(psi))
        weights = np.array([1, *[4, 2] * (len(t) // 2)], float) * t[1] / 3
        weights[-1] = t[1] / 3
        lag = [np.degrees(np.sum(weights * theta * np.cos(t) * (1 / np.cos(a) - 1))) for a in (angle, designed)]
        below(f"{name}: lag of {lag[1]:.3f}°", lag[0] - lag[1], 0.01)


def measured_slots(name, binary, case, path, ring, generator):
    """Points of all faces of the groove with errors of 1 µm give slots back by `cageless measure`, by a drawing that is
    off by tenths of a millimetre."""
    reader = STEPControl_Reader()
    reader.ReadFile(str(path))
    reader.TransferRoots()
    faces = [TopoDS.Face(face) for face in explore(reader.OneShape(), Shape.TopAbs_FACE)]
    points = np.concatenate([face_points(face, 2000, generator) for face in faces])
    points += generator.normal(0.0, 1e-3, points.shape)
    touched = path.with_suffix(".points.csv")
    np.savetxt(touched, points, delimiter=",", header="x_mm,y_mm,z_mm", comments="", fmt="%.7f")
    text, designed = case.read_text(), tomllib.loads(case.read_text())["raceway"]
    for slot in designed:
        for key, factor in (("axial_span_mm", 1.04), ("half_angle_deg", 1.01), ("edge_radius_mm", 0.8)):
            text = text.replace(f"{key} = {slot[key]}\n", f"{key} = {slot[key] * factor}\n")
    drawn, out = path.with_suffix(".drawn.toml"), path.with_suffix(".measured")
    drawn.write_text(text)
    command = [str(c) for c in (binary, "measure", drawn, touched, "--json", "--out", out)]
    found = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)["raceways"]
    entered = tomllib.loads((out / "measured.toml").read_text())["raceway"]
    check(f"{name}: every slot", len(found) == len(entered) == len(ring.slots))
    for said, slot, given in zip(found, entered, designed, strict=True):
        check(f"{name}: points", said["measured_points"] > 2000, said["measured_points"])
        below(f"{name}: deviation, µm", said["measured_deviation_um"] - 1.0, 0.05)
        below(f"{name}: depth error, µm", said["measured_depth_error_um"], 1.0)
        for key, length in (("axial_span_mm", 1), ("edge_radius_mm", 1), ("half_angle_deg", np.radians(1) * ring.ro)):
            below(f"{name}: {key}, µm", 1e3 * length * (slot[key] - given[key]), 5.0)
        below(f"{name}: lag, °", slot_lag(ring, slot) - slot_lag(ring, given), 0.01)


def slot_lag(ring, given):
    """Lag of a ball that rolls through a slot, sink and contact angle included, of equal radii of pitch and orbit, in °."""
    sine, edge = given["axial_span_mm"] / (2 * ring.rw), given["edge_radius_mm"]
    half, theta = (ring.rw + edge) * sine, np.radians(given["half_angle_deg"])
    local = np.linspace(0, theta, 200_001)
    left = 1 - (np.maximum(local - theta + half / ring.ro, 0) * ring.ro / half) ** 2
    square = sine**2 * np.maximum(left, 0)
    cos = np.sqrt(1 - square)
    sink = np.sqrt((ring.re + edge) ** 2 - (ring.rw + edge) ** 2 * square) - (ring.rw + edge) * cos - ring.back
    # Rolling on the inner ring at Ri + s and on two points at the angle αc: ω of the ball set ∝ 1/(1 + ρ/(r cos αc)).
    out = ring.t + sink + ring.rw * cos
    speed = (ring.t + sink - ring.rw) / (ring.t + sink - ring.rw + out / cos)
    return np.degrees(2 * np.trapezoid(speed[-1] / speed - 1, local))


def main():
    binary, scratch = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    scratch.mkdir(parents=True, exist_ok=True)
    generator = np.random.default_rng(1)
    for name, (bearing, raceways, blends) in CASES.items():
        path = scratch / f"{name}.toml"
        case = case_file(binary, path, bearing, raceways)
        for blend in blends:
            ring, which = Ring(case, blend), f"{name}-{blend}"
            more = ("--blend-mm", blend)
            out = scratch / f"{which}.step"
            said = export(binary, path, out, *more)
            step(f"{which} STEP", out, said, ring, generator)
            below(f"{which}: deviation under 0.1 µm by default", said["deviation_um"], 0.1)
            if name in ("structure-d", "two", "turned") and blend == min(blends):
                measured(f"{which} measured", binary, path, out, ring, generator)
            if name in ("slot", "turned-slot"):
                measured_slots(f"{which} measured", binary, path, out, ring, generator)
            check(f"{which}: kink", (said["slope_discontinuity_45_deg"] > 0.1) == (bool(ring.raceways) and blend == 0))
            out = scratch / f"{which}.stl"
            stl(f"{which} STL", out, export(binary, path, out, *more), ring, generator)
            out = scratch / f"{which}.csv"
            points(f"{which} CSV", out, export(binary, path, out, *more), ring)
    # As coarse and as fine as asked for.
    path = scratch / "two.toml"
    ring = Ring(tomllib.loads(path.read_text()), 0.3)
    title(binary, path, scratch / "title.step")
    drawing(binary, scratch / "structure-d.toml", scratch / "sheet")
    for tolerance in (1.0, 0.001):
        out = scratch / f"tolerance-{tolerance}.step"
        said = export(binary, path, out, "--blend-mm", 0.3, "--tolerance-um", tolerance)
        below(f"tolerance {tolerance}", said["deviation_um"], tolerance)
    for chord in (50, 0.5):
        out = scratch / f"chord-{chord}.stl"
        said = export(binary, path, out, "--blend-mm", 0.3, "--chord-um", chord)
        stl(f"chord {chord}", out, said, ring, generator)
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
