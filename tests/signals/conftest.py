"""Options of the numerics' tests."""

import pytest


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--accuracy-table",
        action="store_true",
        help="print the errors of the differentiators in the form of the table in test_differentiation_accuracy.py",
    )
