from pipeline.reporting.datasheet_rows import element_rows


def test_what_does_not_act_is_called_absent():
    acting = {"name": "restoring force", "force_rms": 0.4, "unit": "N", "share": 1.0}
    rubbing = {"name": "dry friction", "force_rms": 0.02, "unit": "N", "share": 0.05}
    rows = element_rows([acting, rubbing, {"name": "drag", "force_rms": 0.0, "unit": "N", "share": 0.0}])
    assert [row[0] for row in rows if row[1] == "absent"] == ["drag"]
    assert rows[1][2] == "5.00 %"
