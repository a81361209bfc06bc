"""The tables of the studies: their names, where they lie in a run, and their columns."""

from typing import Literal

from pipeline.loading.device import Device
from pipeline.runs.schemas import Column, Schema

StudyName = Literal["alpha", "basis", "data", "online", "folds"]
STUDIES: tuple[StudyName, ...] = ("alpha", "basis", "data", "online", "folds")


def study_artifact(name: StudyName) -> str:
    """Where the table of a study lies."""
    return f"studies/{name}.parquet"


def study_schema(name: StudyName, plant: Device) -> Schema:
    """The columns of a study of this device."""
    q = plant.displacement.symbol
    columns = {
        "alpha": (
            Column("alpha", "float64", f"{q}·s^order", "regularisation parameter"),
            Column(
                "misfit", "float64", q, "RMS of record less regularised signal: above the noise, the signal suffers"
            ),
            Column("roughness", "float64", f"{q}/s²", "mean change of the acceleration from sample to sample"),
        ),
        "basis": (
            Column("basis_functions", "float64", "1", "number M of Gaussians per curve"),
            Column("smoothing", "float64", "1", "width over distance of the centres, sigma_n"),
            Column("mse", "float64", f"({q}/s²)²", "mean squared error of the acceleration on the training logs"),
            Column("condition", "float64", "1", "condition number of the regressor"),
            Column("nrmse", "float64", "1", "free-run NRMSE of q on the other logs, at most 1"),
        ),
        "data": (
            Column("samples", "float64", "1", "training samples"),
            Column("noise", "float64", q, "standard deviation of the noise added to q"),
            Column("nrmse", "float64", "1", "median free-run NRMSE of q on the other logs, at most 1"),
            Column("nrmse_low", "float64", "1", "smallest of the repeats"),
            Column("nrmse_high", "float64", "1", "largest of the repeats"),
        ),
        "online": (
            Column("forgetting", "float64", "1", "forgetting factor λ of the recursive least squares"),
            Column("drift", "float64", "1", "share by which the restoring force grows over the log"),
            Column("t", "float64", "s", "length of the stream so far"),
            Column("curve_error", "float64", "1", "RMS error of the restoring force over its range"),
            Column("prediction_error", "float64", "1", "error of the acceleration before each sample, over its RMS"),
        ),
        "folds": (
            Column("model", "string", "1", "name of the model"),
            Column("fold", "int64", "1", "number of the fold that was left out"),
            Column("samples", "int64", "1", "samples of the fold"),
            Column("status", "string", "1", "ok, diverged, refused (no fit without the fold) or empty"),
            Column("nrmse", "float64", "1", "free-run NRMSE of q on the fold, over the range in all data, at most 1"),
            Column("nrmse_qdot", "float64", "1", "that of the velocity"),
            Column("nrmse_qddot", "float64", "1", "that of the acceleration"),
            Column("well_agreement", "float64", "1", "share of the fold's samples in the right well"),
        ),
    }[name]
    return Schema(f"study-{name}", columns)
