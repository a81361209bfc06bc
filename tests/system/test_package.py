"""Places and texts of this package."""

from pipeline.models.model_file import ModelFile
from pipeline.settings.logs import Channel, LogColumn
from pipeline.system.package import texts_below


def test_the_text_below_a_field_is_found_in_the_source_of_the_class_that_declares_it() -> None:
    texts = texts_below(Channel)
    assert texts["channel"] == texts_below(LogColumn)["channel"] == "Name of the channel in the log."
    assert texts["part"].startswith("Part of a signed monitor")
    assert texts_below(ModelFile)["diagnostics"] == ""  # a default and a method lie below
