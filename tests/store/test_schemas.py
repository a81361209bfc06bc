"""The version of the columns changes when they do."""

import hashlib
from dataclasses import replace

from pipeline.device.device import JOINT
from pipeline.store import schemas
from pipeline.store.columns import FACT_COLUMNS, SCHEMA_VERSION
from pipeline.store.schemas import Schema, schema_of
from pipeline.units.units import SiUnit

VERSIONS = {"1": "6759345cecf59ad9", "2": "0ca3f9e57b9bf8ea", "3": "8806036b5542885d"}
"""Digests of the columns by schema version: other columns need a new version, a table more or less a new digest."""


def _schemas() -> list[Schema]:
    kinds = [value for value in vars(schemas).values() if isinstance(value, Schema)] + list(schemas.STUDIES.values())
    measured = replace(JOINT, velocity=SiUnit(1.0, "m/s"))
    return [schema_of(kind, measured, phi=True, tubes=True) for kind in kinds]


def _digest() -> str:
    files = [(schema.kind, [(c.key, c.dtype, c.unit) for c in schema.columns]) for schema in _schemas()]
    facts = [(fact.key, fact.unit) for fact in FACT_COLUMNS]
    return hashlib.sha256(repr((files, facts)).encode()).hexdigest()[:16]


def test_columns_that_changed_have_a_new_version() -> None:
    assert VERSIONS.get(SCHEMA_VERSION) == _digest(), "raise SCHEMA_VERSION and add its digest to VERSIONS"
