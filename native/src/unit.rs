//! Functions compiled together, in memory that is given back when nobody has them any more.

use crate::body::Body;
use crate::lower::{Held, Lowering, Signatures};
use crate::{Care, StepCode, spread};
use cranelift_codegen::ir::{AbiParam, Function, Signature, Type, Value, types};
use cranelift_codegen::settings::{self, Configurable};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{FuncId, Module, default_libcall_names};
use std::collections::HashMap;

/// The memory of some compiled functions; shared freely between threads.
pub(crate) struct Unit(Option<JITModule>);

// SAFETY: the module is touched again only when the last owner drops it; what it compiled is never written after it was
// made, and keeps nothing between calls.
#[expect(unsafe_code, reason = "the compiler's module holds addresses")]
unsafe impl Send for Unit {}
// SAFETY: as above: shared use reads nothing of the module.
#[expect(unsafe_code, reason = "the compiler's module holds addresses")]
unsafe impl Sync for Unit {}

impl Drop for Unit {
    fn drop(&mut self) {
        if let Some(module) = self.0.take() {
            // SAFETY: the addresses of its functions stand beside this value in one owner alone, and nothing runs in it
            // while it is dropped, since a call borrows that owner.
            #[expect(unsafe_code, reason = "gives the memory of the code back")]
            unsafe {
                module.free_memory();
            }
        }
    }
}

/// One function that is to be compiled.
pub(crate) struct Wanted<'a> {
    pub step: &'a StepCode<'a>,
    pub tangents: usize,
    /// The types of its arguments, of which the first is the address of the registers.
    pub parameters: &'a [Type],
    pub result: Option<Type>,
    /// The registers that may have tangents when it begins.
    pub active: &'a [bool],
}

impl Unit {
    /// Room for functions; none where the machine is not known.
    pub fn new(care: Care) -> Option<Self> {
        let mut flags = settings::builder();
        flags.set("opt_level", "none").ok()?;
        flags.set("enable_verifier", "false").ok()?;
        flags.set("is_pic", "false").ok()?;
        let allotted = if care == Care::Little { "single_pass" } else { "backtracking" };
        flags.set("regalloc_algorithm", allotted).ok()?;
        let isa = cranelift_native::builder().ok()?.finish(settings::Flags::new(flags)).ok()?;
        Some(Self(Some(JITModule::new(JITBuilder::with_isa(isa, default_libcall_names())))))
    }

    /// The type of an address.
    pub fn pointer(&self) -> Option<Type> {
        Some(self.0.as_ref()?.target_config().pointer_type())
    }

    /// Compiles a function whose body is built from its arguments.
    pub fn define(
        &mut self,
        wanted: &Wanted<'_>,
        build: impl FnOnce(&mut Body<'_, '_>, &[Value]),
    ) -> Option<FuncId> {
        let module = self.0.as_mut()?;
        let pointer = module.target_config().pointer_type();
        let mut context = module.make_context();
        context.func = Function::new();
        context.func.signature = signature(module, wanted.parameters, wanted.result);
        let mut room = FunctionBuilderContext::new();
        let mut builder = FunctionBuilder::new(&mut context.func, &mut room);
        let called = |b: &mut FunctionBuilder<'_>, of: &[Type]| {
            let kind = signature(module, of, Some(types::F64));
            b.import_signature(kind)
        };
        let signatures = Signatures {
            one: called(&mut builder, &[types::F64]),
            two: called(&mut builder, &[types::F64, types::F64]),
            whole: called(&mut builder, &[types::F64, types::I32]),
        };
        let block = builder.create_block();
        builder.append_block_params_for_function_params(block);
        builder.switch_to_block(block);
        builder.seal_block(block);
        let arguments = builder.block_params(block).to_vec();
        let lowering = Lowering {
            builder: &mut builder,
            base: arguments[0],
            pointer,
            tangents: wanted.tangents,
            active: wanted.active,
            signatures,
            held: vec![Held::default(); wanted.step.active.len()],
            spread: HashMap::new(),
        };
        build(&mut Body { lowering, step: wanted.step }, &arguments);
        builder.finalize();
        let id = module.declare_anonymous_function(&context.func.signature).ok()?;
        module.define_function(id, &mut context).ok()?;
        Some(id)
    }

    /// Makes what was compiled ready to run; whether that went well.
    pub fn finish(&mut self) -> bool {
        self.0.as_mut().is_some_and(|module| module.finalize_definitions().is_ok())
    }

    /// Where a function begins, once all are finished.
    pub fn address(&self, id: FuncId) -> Option<*const u8> {
        Some(self.0.as_ref()?.get_finalized_function(id))
    }
}

fn signature(module: &JITModule, parameters: &[Type], result: Option<Type>) -> Signature {
    let mut signature = module.make_signature();
    signature.params.extend(parameters.iter().map(|t| AbiParam::new(*t)));
    signature.returns.extend(result.map(AbiParam::new));
    signature
}

/// The registers that may have tangents when a whole step begins: the time's own, and the states.
pub(crate) fn before_a_step(step: &StepCode<'_>) -> Vec<bool> {
    let mut active = step.active.to_vec();
    spread(step.time, &mut active);
    step.states.iter().for_each(|r| active[usize::from(*r)] = true);
    active
}

/// Clears the upper halves of the vector registers. The compiled code has instructions of the old encoding among those
/// of the new one, each of which waits for upper halves that other people's code left in use: up to sixty times slower.
pub(crate) fn clear_upper_halves() {
    #[cfg(target_arch = "x86_64")]
    if std::arch::is_x86_feature_detected!("avx") {
        // SAFETY: the machine has the instruction; by the calling convention no upper half lives across a call.
        #[expect(unsafe_code, reason = "an instruction of some machines")]
        unsafe {
            std::arch::x86_64::_mm256_zeroupper();
        }
    }
}
