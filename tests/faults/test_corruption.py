"""Flipped bits, truncations, edits: every read and `verify` find them; set aside, named, and rebuilt."""

import contextlib
import json
import random

import pytest

from pipeline.errors import CorruptArtifactError
from pipeline.store import tables, trees
from pipeline.store.hashing import json_sha256
from pipeline.store.manifest import MANIFEST, load_manifest
from pipeline.store.run_folder import RunFolder
from pipeline.workflow.verify import verify_everything

FLIPS, CUTS = 300, 60


def damaged(content: bytes, rng: random.Random, kind: str) -> bytes:
    if kind == "cut":
        return content[: rng.randrange(len(content))]
    place = rng.randrange(len(content))
    return content[:place] + bytes([content[place] ^ 1 << rng.randrange(8)]) + content[place + 1 :]


def test_no_flipped_bit_and_no_truncation_is_silent(bench):
    """Every artifact spoilt at once, round after round: each is found by `verify` and by whoever reads it."""
    bench.start("intact")
    rng, done = random.Random(6), 0
    assert {name.rpartition(".")[2] for name in bench.expected} >= {"parquet", "h5", "json", "html", "svg", "pdf"}
    good = {name: (bench.run / name).read_bytes() for name in bench.expected}
    while done < FLIPS + CUTS:
        for name, content in good.items():
            (bench.run / name).write_bytes(damaged(content, rng, "flip" if done < FLIPS else "cut"))
            done += 1
        assert {problem["artifact"] for problem in verify_everything(bench.run).problems} == set(good)
        run = RunFolder.open(bench.run)
        for name in good:
            with pytest.raises(CorruptArtifactError, match="sets it aside and redoes stage"):
                run.checked(name)


def test_no_damage_of_the_manifest_is_silent(bench):
    bench.start("intact")
    rng, path = random.Random(9), bench.run / MANIFEST
    good = path.read_bytes()
    for i in range(48):
        spoilt = damaged(good, rng, "flip" if i < 40 else "cut")
        path.write_bytes(spoilt)
        if _content(spoilt) == _content(good):  # an E for an e, or a 17th digit that no double has
            load_manifest(bench.run)
            continue
        with pytest.raises(CorruptArtifactError, match=MANIFEST):
            load_manifest(bench.run)


def _content(text: bytes) -> object:
    """What a manifest means; None where it is no JSON."""
    with contextlib.suppress(ValueError):
        return json.loads(text)
    return None


def _forged(path, change) -> None:
    document = json.loads(path.read_bytes())
    del document["digest"]
    change(document)
    text = json.dumps({**document, "digest": json_sha256(document)}, indent=1, ensure_ascii=False)
    path.write_text(text + "\n", encoding="utf-8")


@pytest.mark.parametrize(
    ("key", "value", "said"),
    [
        ("recipe", {}, r"recipe\.stage: field required"),
        ("sha256", "../x", r"sha256: string should match pattern"),
        ("bytes", -1, r"bytes: input should be greater than"),
    ],
)
def test_a_forged_key_is_named(bench, key, value, said):
    bench.start("intact")
    name = next(name for name in bench.expected if "predictions" in name)
    _forged(bench.run / MANIFEST, lambda document: document["artifacts"][name].update({key: value}))
    with pytest.raises(CorruptArtifactError, match=rf"{MANIFEST}: artifacts\.{name}\.{said}"):
        load_manifest(bench.run)


def test_what_is_damaged_is_set_aside_named_and_rebuilt(bench):
    bench.start("intact")
    rng = random.Random(7)
    spoilt = {name: damaged((bench.run / name).read_bytes(), rng, "flip") for name in bench.expected}
    for name, content in spoilt.items():
        (bench.run / name).write_bytes(content)
    bench.make()
    assert {name: record.content_hash for name, record in load_manifest(bench.run).artifacts.items()} == bench.expected
    aside = {path.relative_to(bench.run).as_posix(): path for path in bench.run.rglob("*.corrupt-*")}
    assert {name.partition(".corrupt-")[0] for name in aside} == set(bench.expected)
    for name, path in aside.items():
        assert path.read_bytes() == spoilt[name.partition(".corrupt-")[0]]


def test_a_page_of_a_table_is_checked_even_without_the_manifest(bench):
    """Bits between the file's magic numbers and its footer: Arrow's page checksums; gzip and Fletcher-32 of HDF5."""
    bench.start("intact")
    path = bench.run / "train" / "train" / "record.parquet"
    good, rng, found = path.read_bytes(), random.Random(8), 0
    footer = int.from_bytes(good[-8:-4], "little") + 8
    intact = tables.read_table(path)
    for _ in range(60):
        place = rng.randrange(4, len(good) - footer)
        path.write_bytes(good[:place] + bytes([good[place] ^ 1 << rng.randrange(8)]) + good[place + 1 :])
        try:
            table = tables.read_table(path)
        except CorruptArtifactError:
            found += 1
        else:  # a bit of a page's header that means nothing
            assert all((table[name] == intact[name]).all() or name == "q" for name in intact)
    assert found >= 55
    model = bench.run / "model.h5"
    model.write_bytes(model.read_bytes()[:-100])
    with pytest.raises(CorruptArtifactError, match="damaged or incomplete"):
        trees.read_tree(model)
