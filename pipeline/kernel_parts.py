"""Compile a kernel once, however many others call it: numba's front end for each function, LLVM for what Python calls.

numba makes of every function, those too that only other kernels call, a wrapper for Python, optimised code and machine
code, and then optimises it again within each of its callers. Here a function that a kernel calls is a `Part`: types
and LLVM's intermediate code, no more. `entry` joins the parts, adds the wrapper, and lets LLVM work once.
"""

# mypy: disable-error-code="no-untyped-call,misc,attr-defined,assignment"

import gc
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from copy import copy
from typing import Any

from llvmlite.binding import parse_bitcode
from numba.core.codegen import JITCodeLibrary
from numba.core.compiler import Compiler, Flags
from numba.core.compiler_lock import global_compiler_lock
from numba.core.compiler_machinery import register_pass
from numba.core.environment import Environment, lookup_environment
from numba.core.registry import CPUDispatcher
from numba.core.target_extension import jit_registry
from numba.core.typed_passes import NativeLowering


def entry(part: "Part", types: tuple[Any, ...], nogil: bool) -> Any:
    """Machine code of a part and all that it calls, and the function by which Python calls it."""
    made = part.compiled(types)
    context, fndesc = made.target_context, copy(made.fndesc)
    # What the wrapper needs of Python is its own: the part is in kernels, too, that are kept without a wrapper for it.
    fndesc.env_name += ".entry"
    own = Environment.from_fndesc(fndesc)
    library = EntryLibrary(context.codegen(), fndesc.qualname)
    library._reload_init.update(made.library._reload_init)
    library.add_linking_library(made.library)
    with context.push_code_library(library):
        context.create_cpython_wrapper(library, fndesc, own, made.call_helper, release_gil=nogil)
    function = context.get_executable(library, fndesc, own)
    for variable in library._final_module.global_variables:
        environment = lookup_environment(variable.name)
        if environment is not None:
            library.codegen.set_env(variable.name, environment)
    return made._replace(library=library, entry_point=function, fndesc=fndesc, environment=own, metadata={})


class EntryLibrary(JITCodeLibrary):
    """The code of a kernel with all that it calls, which becomes machine code.

    Attributes
    ----------
    inlined : bytes
        LLVM's code before anything was done that depends on the processor, as `finish` takes it.
    """

    inlined = b""

    def __init__(self, codegen: Any, name: str) -> None:
        super().__init__(codegen, name)
        self.enable_object_caching()

    def finish(self, inlined: bytes) -> None:
        """Make machine code of what another process has begun."""
        self._final_module = parse_bitcode(inlined)
        self._optimize_fully()
        self._finalize_final_module()

    def _optimize_final_module(self) -> None:
        managers = self._codegen._module_pass_manager(
            loop_vectorize=False, slp_vectorize=False, opt=self._codegen._opt_level, cost="cheap"
        )
        managers[0].run(self._final_module, managers[1])
        self.inlined = self._final_module.as_bitcode()
        self._optimize_fully()

    def _optimize_fully(self) -> None:
        passes, builder = self._codegen._module_pass_manager()
        passes.run(self._final_module, builder)


class Part(CPUDispatcher):
    """A function as other kernels call it, without anything for Python."""

    def __init__(self, function: Callable[..., Any], targetoptions: dict[str, Any]) -> None:
        named = {name: value for name, value in targetoptions.items() if name != "nogil"}
        options = {**named, "nopython": True, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
        super().__init__(function, targetoptions=options, pipeline_class=_PartCompiler)
        self._compiler._customize_flags = _Flags

    def compiled(self, types: tuple[Any, ...]) -> Any:
        """Its intermediate code for arguments of these types, made once in a process."""
        with _compiling_parts():
            self.compile(types)
        return self.overloads[types]

    def add_overload(self, result: Any) -> None:
        """Keep a version; there is nothing that Python could call."""
        self.overloads[tuple(result.signature.args)] = result


@contextmanager
def _compiling_parts() -> Iterator[None]:
    """Within, numba's own functions, as ``np.empty``, are parts as well, and no garbage is collected.

    A compilation makes millions of objects that stay; looking through them again and again took a fifth of its time.
    """
    with global_compiler_lock:
        outermost, collecting = "generic" not in jit_registry, gc.isenabled()
        if outermost:
            jit_registry["generic"] = _part_decorator
            gc.disable()
        try:
            yield
        finally:
            if outermost:
                del jit_registry["generic"]
            if outermost and collecting:
                gc.enable()


def _part_decorator(**options: Any) -> Callable[..., Part]:
    return lambda function: Part(function, options)


class _Flags(Flags):
    """Flags that are compared by what was set: numba asks for each of 30 options, 65,000 times in a first run."""

    __slots__ = ()

    def __init__(self, copy_from: Any = None) -> None:
        super().__init__(copy_from)
        self.no_compile = True

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Flags) and self._values == other._values

    def __hash__(self) -> int:
        return hash(frozenset(self._values))


class _PartLibrary(JITCodeLibrary):
    """Code that is optimised and becomes machine code in the kernels that call it only."""

    def _optimize_final_module(self) -> None:
        pass

    def _finalize_final_module(self) -> None:
        self._finalize_dynamic_globals()
        self._finalized = True


@register_pass(mutates_CFG=True, analysis_only=False)
class _PartLowering(NativeLowering):
    _name = "part_lowering"

    def run_pass(self, state: Any) -> bool:
        state.library = _PartLibrary(state.targetctx.codegen(), state.func_id.func_qualname)
        super().run_pass(state)
        state.cr = state.cr._replace(cfunc=_Callable())
        state.targetctx.insert_user_function(state.cr.cfunc, state.cr.fndesc, [state.library])
        return True


class _Callable:
    """What numba looks a compiled function up by; a part's cannot be called."""


class _PartCompiler(Compiler):
    def define_pipelines(self) -> list[Any]:
        (passes,) = super().define_pipelines()
        passes.passes = [
            (_PartLowering, about) if each is NativeLowering else (each, about) for each, about in passes.passes
        ]
        passes._finalized = False
        passes.finalize()
        return [passes]
