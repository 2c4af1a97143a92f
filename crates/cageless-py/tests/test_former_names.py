"""Former names of keys are read, with a warning that gives the present name."""

from __future__ import annotations

import cageless
import pytest


def test_a_former_key_is_the_key() -> None:
    text = cageless.template()
    former = text.replace("\ndamping_n_s_m1_5 = ", "\ndamping = ")
    assert former != text
    with pytest.warns(FutureWarning, match="contact.damping is now contact.damping_n_s_m1_5"):
        case = cageless.Case.from_toml(former)
    assert case == cageless.Case.from_toml(text)
    with pytest.warns(FutureWarning, match="rotor.air_gap_um is now rotor.radial_clearance_um|slip_scale_m_s is now"):
        changed = case.replace({"contact.slip_scale_m_s": 0.03})
    assert changed.contact.regularisation_speed_m_s == 0.03
