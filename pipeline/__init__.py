"""From the raw rig log of a bistable dielectric-elastomer joint to a validated dynamic model.

The stages run in the order ingest → differentiate → identify → validate → compare → report and meet
only through artifacts; `docs/explanation/architecture.md` draws the flow.
"""

__version__ = "0.2.0"
