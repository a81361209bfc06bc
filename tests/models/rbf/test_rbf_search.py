"""Which answer the search takes, from errors that are given: white, so that every sample counts."""

from dataclasses import replace

import numpy as np
import pytest

from pipeline.models.rbf import structure_search
from pipeline.models.rbf.candidates import candidate
from pipeline.models.rbf.problem import Effort
from pipeline.models.rbf.structure import JointStructure
from pipeline.models.rbf.structure_search import Setting, search
from pipeline.signals.trajectory import Record

PLAIN = JointStructure(
    5, rates=(), shape_elements=0, slips=0, arc=False, force="polynomial", constant_damping=True, constant_gain=True
)
FREE, CURVED, DRAGGED, STOPPED = (
    candidate(replace(PLAIN, **change))
    for change in ({"force": "offset"}, {"force": "curve"}, {"drag": True}, {"stops": True})
)
SPRING = candidate(PLAIN)


def judged_as(errors, fitted):
    """A judgement from the held-out errors of each fold and those over what was fitted."""
    return structure_search._Judged(tuple(errors), fitted, ((None, np.empty(0)),), False, ())


@pytest.fixture
def found(monkeypatch):
    """What the search takes, and what was judged: errors over held-out data and over what was fitted, by candidate."""
    t = 0.01 * np.arange(400)
    record = Record(t, np.sin(t), np.cos(t), -np.sin(t), np.cos(3.0 * t)[:, None], np.ones(400, dtype=bool))

    def searched(errors, once, again=()):
        judged = []

        def judge(records, setting, one, near):
            judged.append(one)
            held_out, fitted = errors(one) if callable(errors) else errors[one.label]
            noise = np.abs(np.random.default_rng(1).normal(1.0, 0.1, (2, 400)))
            return judged_as([held_out * noise], fitted * noise[0])

        monkeypatch.setattr(structure_search, "_judge", judge)
        return search([record], Setting("linear", None), SPRING, once, again).chosen, judged

    return searched


def test_a_search_says_whether_all_was_asked(monkeypatch):
    """The effort that is spent by the last candidate leaves nothing out; that which is spent before it does."""
    t = 0.01 * np.arange(400)
    record = Record(t, np.sin(t), np.cos(t), -np.sin(t), np.cos(3.0 * t)[:, None], np.ones(400, dtype=bool))

    def judge(records, setting, one, near):
        setting.effort.spent += 1.0
        return judged_as([np.ones((2, 400))], np.ones(400))

    monkeypatch.setattr(structure_search, "_judge", judge)
    offers = [only(CURVED), only(DRAGGED)]  # with the first candidate three to be judged
    told = {}
    for limit in (1.0, 2.0, 3.0, 4.0):
        effort = Effort(limit / structure_search.SEARCH_SHARE)
        told[limit] = search([record], Setting("linear", None, effort), SPRING, offers).complete
    assert told == {1.0: False, 2.0: False, 3.0: True, 4.0: True}


def only(one):
    """An offer of one candidate whatever is best."""
    return lambda best: [one]


def test_a_larger_structure_must_err_surely_less(found):
    errors = {SPRING.label: (1.0, 1.0), CURVED.label: (0.8, 0.5), DRAGGED.label: (1.0, 0.1)}
    assert found(errors, [only(CURVED)])[0] == CURVED
    assert found(errors, [only(DRAGGED)])[0] == SPRING  # however well it follows what it was fitted to


@pytest.mark.parametrize(("held_out", "fitted", "taken"), [(1.0, 1.3, FREE), (1.2, 1.0, SPRING), (1.0, 2.0, SPRING)])
def test_a_smaller_one_is_taken_if_it_errs_no_more_and_follows_what_it_was_fitted_to(found, held_out, fitted, taken):
    errors = {SPRING.label: (1.0, 1.0), FREE.label: (held_out, fitted)}
    assert found(errors, [only(FREE)])[0] == taken


def test_simplifications_that_are_each_within_a_standard_error_do_not_add_up(found):
    """Each errs 4 % more than the one before, which 400 independent samples do not tell; 8 % they do."""
    curves = [replaced(CURVED, basis_functions=size) for size in (12, 11, 10, 9, 8, 7, 6)]
    rng = np.random.default_rng(3)
    white = rng.normal(0.0, 0.1, (2, 400))
    errors = {one.label: (1.04**k * rng.permutation(white, axis=1), 1.0) for k, one in enumerate(curves)}
    chosen, judged = found(errors | {SPRING.label: (1.0, 1.0)}, [only(one) for one in curves])
    assert len(judged) == 1 + len(curves)
    assert chosen in curves[:3]


def test_what_depends_on_other_fields_is_offered_again_until_nothing_is_taken(found):
    """Drag helps only once there are stops, and is offered before them."""
    both = candidate(replace(PLAIN, drag=True, stops=True))
    errors = {SPRING.label: (1.0, 1.0), DRAGGED.label: (1.0, 1.0), STOPPED.label: (0.8, 1.0), both.label: (0.5, 1.0)}
    bests = []

    def drag(best):
        bests.append(best)
        return [replaced(best, drag=True)]

    assert found(errors, [], [drag, lambda best: [replaced(best, stops=True)]])[0] == both
    assert bests == [SPRING, STOPPED, both]


def replaced(one, **changes):
    """A candidate with some of its structure changed."""
    return candidate(replace(one.structure, **changes))
