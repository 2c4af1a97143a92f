"""Options of figures: balls, time, title; figures of static results."""

from __future__ import annotations

import cageless
import numpy as np
import plotly.graph_objects as go
import pytest
from conftest import lively


@pytest.fixture(scope="module")
def run() -> cageless.Run:
    return lively().run()


def shown(figure: go.Figure) -> dict[str, go.Scatter]:
    return {trace.name: trace for trace in figure.data if trace.name}


def test_balls_are_those_chosen(run: cageless.Run) -> None:
    figure = run.plot_gaps(balls=[3, 7], time_s=(0.0, 0.02))
    assert set(shown(figure)) == {"ball 3", "ball 7"}
    trace = shown(figure)["ball 7"]
    assert trace.visible is True
    # Times of figures are rounded.
    rows = np.abs(run.time_s - np.asarray(trace.x, float)[:, None]).argmin(axis=1)
    expected = np.degrees(run.gap_rad[rows, 6])
    assert np.allclose(np.asarray(trace.y, float), expected, rtol=1e-3, atol=1e-6)
    assert set(shown(run.plot_sliding(balls=2))) == {"ball 2"}
    assert run.plot_gaps(balls=np.array([3, 7]), time_s=np.array([0.0, 0.02])) == figure
    assert run.plot_sliding(balls=np.int64(2)) == run.plot_sliding(balls=2)
    assert shown(run.plot_phase(ball=4)).keys() == {"ball 4"}
    assert run.plot_loads(ball=5) != run.plot_loads()


def test_a_window_of_time_has_every_output_time(run: cageless.Run) -> None:
    figure = run.plot_gaps(time_s=(0.004, 0.006))
    times = np.asarray(shown(figure)["ball 1"].x, float)
    inside = run.time_s[(run.time_s >= 0.004) & (run.time_s <= 0.006)]
    assert len(times) == len(inside) > 10
    assert np.allclose(times, inside, rtol=1e-5)
    low, high = figure.layout.xaxis.range
    assert (low, high) == pytest.approx((inside[0], inside[-1]))
    collided = run.plot_collisions(time_s=(0.0, 0.01)).data[0].x
    starts = run.array("start_s")
    assert len(collided) == np.count_nonzero(starts <= 0.01) < len(starts)


def test_every_figure_takes_a_title(run: cageless.Run) -> None:
    in_space = ("plot_contact_angles", "plot_groove")
    for name in (n for n in dir(run) if n.startswith("plot_") and n not in in_space):
        plain, titled = getattr(run, name)(), getattr(run, name)(title="Mine")
        assert titled.layout.title.text == "Mine"
        assert titled.layout.height > plain.layout.height


def test_impossible_choices_are_refused(run: cageless.Run) -> None:
    with pytest.raises(cageless.InputError, match="balls = 15 .* a whole number from 1 to 14"):
        run.plot_gaps(balls=[1, 15])
    with pytest.raises(cageless.InputError, match="balls = '1' is not possible"):
        run.plot_gaps(balls="1")
    with pytest.raises(cageless.InputError, match="balls = 1.5 is not possible"):
        run.plot_gaps(balls=1.5)
    with pytest.raises(cageless.InputError, match="balls = 0 "):
        run.plot_phase(ball=0)
    with pytest.raises(cageless.InputError, match=r"balls = \[\] is not possible"):
        run.plot_gaps(balls=[])
    with pytest.raises(cageless.InputError, match="time_s = .* two of the output times"):
        run.plot_sliding(time_s=(0.5, 0.6))
    with pytest.raises(cageless.InputError, match="time_s = .NaN, 2. is not possible"):
        run.plot_sliding(time_s=(float("nan"), 2.0))
    for one in (3, "ab", (0.1,), (0.1, True), (0.1, "0.2")):
        with pytest.raises(cageless.InputError, match=r"time_s = .* two numbers, from and to"):
            run.plot_sliding(time_s=one)


def test_loads_of_a_static_result_are_drawn_round_the_ring() -> None:
    static = cageless.Case.from_toml(cageless.template()).static()
    figure = static.plot_loads(title="Loads")
    assert figure.layout.title.text == "Loads"
    outer, inner, outer_pressure, _ = (t for t in figure.data if t.type == "barpolar")
    # Values of figures are rounded.
    assert np.allclose(outer.r, static.outer_force_n, rtol=1e-3)
    assert np.allclose(inner.r, static.inner_force_n, rtol=1e-3)
    assert np.allclose(outer.theta, static.ball_angle_deg, rtol=1e-3)
    assert max(outer_pressure.r) > 1000.0  # MPa
    # ψ = 0 is at the bottom.
    assert figure.layout.polar.angularaxis.rotation % 360 == 270
    # Drawn to the end: what plotly refuses, it refuses here.
    assert "barpolar" in figure.to_html(include_plotlyjs=False)
