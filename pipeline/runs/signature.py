"""A keyed signature of a run: who has the key can tell whether anything in the run was replaced, hashes included.

HMAC-SHA-256 (RFC 2104) of the manifest, which holds the hash of every artifact, of the lists that hold those of studies
and exports, and of the time of signing. Whoever shall check it needs the same
key, by a way of its own: the signature keeps out who does not have the key, and does not tell those apart who do.
"""

import hashlib
import hmac
import json
import os
import secrets
import stat
from datetime import UTC, datetime
from pathlib import Path

from pipeline.errors import CorruptArtifactError, InputError
from pipeline.plain_files import read_plain
from pipeline.runs.atomic import write_text
from pipeline.runs.confined import not_written
from pipeline.runs.manifest import manifest_bytes
from pipeline.runs.outputs import EXTRA_FOLDERS, written_files
from pipeline.runs.run_folder import RunFolder

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
