"""Everything in a run folder against what was written, with the rest named; and a keyed signature of all of it.

The signature is HMAC-SHA-256 (RFC 2104) of the manifest, which holds the hash of every artifact, of the lists that hold
those of studies and exports, and of the time of signing. Who has the key can tell whether anything in the run was
replaced, hashes included. Whoever shall check it needs the same key, by a way of its own: the signature keeps out who
does not have the key, and does not tell those apart who do.
"""

import hashlib
import hmac
import json
import os
import secrets
import stat
from collections.abc import Iterator
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path

from pipeline.errors import CorruptArtifactError, InputError
from pipeline.plain_files import read_plain
from pipeline.runs import layout
from pipeline.runs.atomic import TEMPORARY_MARK, write_text
from pipeline.runs.checkpoints import FOLDER as CHECKPOINTS
from pipeline.runs.confined import not_written
from pipeline.runs.hashing import file_sha256
from pipeline.runs.lock import HOLDER, LOCK
from pipeline.runs.manifest import MANIFEST, NEXT_MANIFEST, STAGED_MARK, manifest_bytes
from pipeline.runs.outputs import EXTRA_FOLDERS, WRITTEN, written_files
from pipeline.runs.run_folder import CORRUPT_MARK, RunFolder
from pipeline.runs.stage_manifest import FOLDER as STAGES
from pipeline.runs.stage_manifest import said_content

SIGNATURE = "signature.json"
FORMAT = "debist-signature/2"
_FEWEST_BYTES, _MOST_BYTES, _NEW_BYTES = 16, 4096, 32
_LARGEST = 1 << 16
_OTHERS = stat.S_IRWXO


def make_key(path: Path) -> None:
    """Write a new key that its owner alone can read.

    Raises
    ------
    InputError
        The file is there already, or cannot be written.
    """
    try:
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW, 0o600)
        with os.fdopen(descriptor, "w", encoding="ascii") as stream:
            stream.write(secrets.token_hex(_NEW_BYTES) + "\n")
    except FileExistsError:
        raise InputError(f"{path}: is there already; sign with it, or name another file for a new key") from None
    except OSError as error:
        raise not_written(path, error) from error


def load_key(path: Path) -> bytes:
    """The key in a file, without blanks around it.

    Raises
    ------
    InputError
        It cannot be read, everybody can read it, or it is too short to be one.
    """
    try:
        mode, key = path.stat().st_mode, read_plain(path, _MOST_BYTES).strip()
    except OSError as error:
        raise InputError(f"{path}: the key cannot be read: {error.strerror}") from error
    if mode & _OTHERS:
        raise InputError(f"{path}: everybody can read this key; chmod 600 it, and take a new one")
    if len(key) < _FEWEST_BYTES:
        raise InputError(f"{path}: is no key (fewer than {_FEWEST_BYTES} bytes); `debist sign --new-key` makes one")
    return key


def sign(run: RunFolder, key: bytes) -> Path:
    """Sign the state of a run; call it as the only writer, on a run that is intact."""
    signed = datetime.now(UTC).isoformat(timespec="seconds")
    document = {"format": FORMAT, "key": _key_name(key), "signed": signed, "hmac_sha256": _code(run, signed, key)}
    target = run.root / SIGNATURE
    write_text(target, json.dumps(document, indent=1) + "\n", within=run.root)
    return target


def check_signature(run: RunFolder, key: bytes) -> str:
    """Make sure that a run is in the state that was signed with this key; when that was.

    Raises
    ------
    CorruptArtifactError
        It is not signed, by another key, or was changed since.
    """
    path = run.root / SIGNATURE
    try:
        document = json.loads(read_plain(path, _LARGEST))
        code, name, signed = (str(document[field]) for field in ("hmac_sha256", "key", "signed"))
    except FileNotFoundError:
        raise CorruptArtifactError(f"{run.root}: is not signed; `debist sign` does it") from None
    except (OSError, ValueError, KeyError, TypeError, RecursionError) as error:
        raise CorruptArtifactError(f"{path}: damaged ({type(error).__name__}); have the run signed again") from error
    if not hmac.compare_digest(code.encode(errors="replace"), _code(run, signed, key).encode()):
        why = "was changed after it was signed" if name == _key_name(key) else "was signed with another key"
        raise CorruptArtifactError(f"{run.root}: {why}; get the run from who signed it, or have it signed again")
    return signed


def _code(run: RunFolder, signed: str, key: bytes) -> str:
    lists = {folder: written_files(run.root / folder) for folder in EXTRA_FOLDERS}
    head = json.dumps([FORMAT, signed, lists], sort_keys=True).encode()
    return hmac.new(key, head + b"\n" + manifest_bytes(run.manifest), hashlib.sha256).hexdigest()


def _key_name(key: bytes) -> str:
    """Tells keys apart without telling them."""
    return hmac.new(key, b"debist key name", hashlib.sha256).hexdigest()[:16]


_OWN = frozenset({MANIFEST, NEXT_MANIFEST, LOCK, HOLDER, SIGNATURE})


@dataclass(frozen=True)
class Verified:
    """What a look at everything in a run folder found.

    Attributes
    ----------
    checked : int
        Number of artifacts.
    problems : list of dict
        ``artifact``, ``stage``, ``problem`` for each file that is not as it was written.
    unknown : list of str
        Files that debist did not write there, by their paths in the folder; links among them.
    """

    checked: int
    problems: list[dict[str, str]] = field(default_factory=list)
    unknown: list[str] = field(default_factory=list)


def verified(run: RunFolder) -> Verified:
    """Check every file of a run.

    Raises
    ------
    SupersededError
        Another process went on writing into it.
    """
    problems = [
        {"artifact": name, "stage": stage, "problem": problem}
        for name, stage, problem in (*_artifacts(run), *_stage_manifests(run), *_extra_files(run.root))
    ]
    return Verified(len(run.manifest.artifacts), problems, sorted(_unknown(run)))


def _artifacts(run: RunFolder) -> Iterator[tuple[str, str, str]]:
    for name, record in sorted(run.manifest.artifacts.items()):
        try:
            problem = run.problem(name)
        except InputError as error:  # the disk refuses to read it; the others shall be checked nevertheless
            problem = str(error)
        if problem:
            yield name, record.recipe.stage, problem


def _stage_manifests(run: RunFolder) -> Iterator[tuple[str, str, str]]:
    """Workflow engines trust them."""
    for path in sorted((run.root / STAGES).glob("*.json")):
        said = said_content(path)
        known = {
            name: run.manifest.artifacts[name].content_hash for name in said or () if name in run.manifest.artifacts
        }
        if said is None or said != known:
            yield f"{STAGES}/{path.name}", path.stem, "does not say what the manifest says; `debist run` writes it anew"


def _extra_files(root: Path) -> Iterator[tuple[str, str, str]]:
    for folder in EXTRA_FOLDERS:
        for name, entry in sorted(written_files(root / folder).items()):
            path = root / folder / name
            try:
                if path.is_file() and file_sha256(path) != entry.get("sha256"):
                    yield (
                        f"{folder}/{name}",
                        entry.get("command", folder),
                        "was changed after it was written; write it anew",
                    )
            except OSError as error:
                yield f"{folder}/{name}", folder, f"cannot be read: {error.strerror}"


def _unknown(run: RunFolder) -> Iterator[str]:
    artifacts = run.manifest.artifacts
    extra = {f"{folder}/{name}" for folder in EXTRA_FOLDERS for name in (WRITTEN, *written_files(run.root / folder))}
    for place, folders, files in os.walk(run.root):
        links = [name for name in folders if (Path(place) / name).is_symlink()]
        for name in (*files, *links):
            path = (Path(place) / name).relative_to(run.root).as_posix()
            of_a_kill = name.startswith(".") and name.endswith((TEMPORARY_MARK, STAGED_MARK))
            of_a_stage = path.startswith(f"{STAGES}/") and path.endswith(".json")
            was = path.partition(CORRUPT_MARK)[0]
            set_aside = was in artifacts or (was != path and bool(layout.command_of(was)))
            finished = path.startswith(f"{CHECKPOINTS}/")
            known = (
                finished or path in artifacts or path in _OWN or path in extra or of_a_kill or of_a_stage or set_aside
            )
            if not known or (Path(place) / name).is_symlink():
                yield path
