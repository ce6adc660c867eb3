//! The register code of the rates.

/// Number of a register.
pub type Register = u16;

/// What an instruction does with its registers a, b, c.
#[derive(Debug, Clone, Copy)]
pub enum Action {
    /// a + b
    Add,
    /// a − b
    Sub,
    /// a·b
    Mul,
    /// a/b
    Div,
    /// −a
    Negative,
    /// a·b + c
    MulAdd,
    /// c − a·b
    MulSub,
    /// a²
    Square,
    /// a³
    Cube,
    /// b where a > 0, else c
    Select,
    /// A function f(a); the second is its slope f′(a) from a and f(a).
    One(extern "C" fn(f64) -> f64, extern "C" fn(f64, f64) -> f64),
    /// A function f(a, b); the others are its slopes by a and by b, from a and b.
    Two(extern "C" fn(f64, f64) -> f64, extern "C" fn(f64, f64) -> f64, extern "C" fn(f64, f64) -> f64),
    /// A function f(a, n) of a whole number n = b as a signed number, and its slope by a.
    Whole(extern "C" fn(f64, i32) -> f64, extern "C" fn(f64, i32) -> f64),
    /// 1 where a > 0, −1 where a < 0, else 0; without slope.
    Sign,
    /// 1 where a ≥ 0, −1 where a < 0, else 0; without slope.
    SignOrOne,
    /// 1 where a ≥ 0, else 0; without slope.
    Step,
    /// √a, with slope 0 where a is 0
    Sqrt,
}

/// One instruction: `to` = action(a, b, c). Registers that an action does not use may be any number.
#[derive(Debug, Clone, Copy)]
pub struct Op {
    /// What is done.
    pub action: Action,
    /// The register that takes the result.
    pub to: Register,
    /// First operand.
    pub a: Register,
    /// Second operand.
    pub b: Register,
    /// Third operand.
    pub c: Register,
}

impl Op {
    /// The registers that it reads.
    pub(crate) fn operands(&self) -> impl Iterator<Item = Register> {
        let count = match self.action {
            Action::Negative
            | Action::Square
            | Action::Cube
            | Action::One(..)
            | Action::Whole(..)
            | Action::Sign
            | Action::SignOrOne
            | Action::Step
            | Action::Sqrt => 1,
            Action::Add | Action::Sub | Action::Mul | Action::Div | Action::Two(..) => 2,
            Action::MulAdd | Action::MulSub | Action::Select => 3,
        };
        [self.a, self.b, self.c].into_iter().take(count)
    }
}

/// What of a step is one function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The two halves of a step of the classical method of order 4.
    Classical,
    /// A step of Heun's method.
    Heun,
    /// No step: the caller puts it together from rates and slopes.
    None,
}

impl Method {
    /// Times within a step, after its begin, at which the rates are asked for.
    pub fn stages(self) -> usize {
        match self {
            Self::Classical => 2,
            Self::Heun => 1,
            Self::None => 0,
        }
    }
}

/// The rates of a model as register code.
#[derive(Debug, Clone)]
pub struct StepCode<'a> {
    /// The instructions that a new time asks for, before those of the states.
    pub time: &'a [Op],
    /// The instructions that give the rates from the states and from what stands in other registers.
    pub code: &'a [Op],
    /// The instructions that give outputs afterwards.
    pub output: &'a [Op],
    /// The instructions that give the motion of guards afterwards.
    pub motion: &'a [Op],
    /// The instructions that give the slopes of the rates afterwards; compiled without a method alone.
    pub slopes: &'a [Op],
    /// The registers that hold the states.
    pub states: &'a [Register],
    /// The registers that hold the rates afterwards, one a state.
    pub rates: &'a [Register],
    /// The registers of signs that may be between −1 and 1, with tangents, where no whole step is taken.
    pub signs: &'a [Register],
    /// For every register, whether it may have tangents when the instructions of the time begin. (States always may.)
    pub active: &'a [bool],
    /// Whether what the code of the states computes is left in the registers, register by register.
    pub kept: &'a [bool],
    /// Which whole steps are compiled.
    pub method: Method,
    /// How much the compiler takes upon itself.
    pub care: Care,
}

/// How the compiler allots the processor's registers. The values are the same.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Care {
    /// In one pass: compiled in a third of the time, and some fifth slower.
    Little,
    /// With what was allotted taken back where that serves.
    Much,
}

/// A switch: the register of its sign, and that of the guard which must not have the other one.
#[derive(Debug, Clone, Copy)]
pub struct Switch {
    /// The register of the sign.
    pub sign: Register,
    /// The register of the guard.
    pub guard: Register,
    /// Whether the guard may not be 0 either.
    pub is_strict: bool,
}

/// What many steps one after the other need besides the code of one.
#[derive(Debug, Clone, Copy)]
pub struct MarchCode<'a> {
    /// The registers that are loaded before the code of a time, as plain numbers.
    pub loaded: &'a [Register],
    /// The switches that end a march.
    pub switches: &'a [Switch],
    /// Registers that take the value of another one after every step, before the outputs.
    pub held: &'a [(Register, Register)],
    /// For each list that is written: the registers that one entry of it holds.
    pub written: &'a [Vec<Register>],
    /// Whether what is loaded may jump where a step begins.
    pub jumps: bool,
}

impl MarchCode<'_> {
    /// Whether every register is one of so many.
    #[cfg_attr(not(feature = "jit"), expect(dead_code, reason = "nothing is compiled without the feature"))]
    pub(crate) fn is_sound(&self, registers: usize) -> bool {
        let switches = self.switches.iter().flat_map(|s| [s.sign, s.guard]);
        let held = self.held.iter().flat_map(|h| [h.0, h.1]);
        let plain = self.loaded.iter().chain(self.written.iter().flatten()).copied();
        plain.chain(switches).chain(held).all(|r| usize::from(r) < registers) && self.written.len() <= LISTS
    }
}

/// A state beyond this has blown up.
pub const TOO_LARGE: f64 = 1e100;

/// Lists that a march may write.
pub const LISTS: usize = 7;

/// What is asked of a step: bit i for an entry of list i at its end, bit 8 + i for one at its begin where what is loaded
/// jumps there, which [`JUMP`] says.
pub type Mark = u16;

/// The mark of a step at whose begin what is loaded jumps.
pub const JUMP: Mark = 1 << 7;

/// Bits to shift by from a list's mark at the end of a step to that at its begin.
pub const BEGIN: u32 = 8;

/// Instructions times words a number that are worth compiling at most.
const LARGEST: usize = 60_000;

impl StepCode<'_> {
    /// Whether every register exists and the work of compiling is bounded, with numbers of so many words.
    #[cfg_attr(not(feature = "jit"), expect(dead_code, reason = "nothing is compiled without the feature"))]
    pub(crate) fn is_sound(&self, words: usize) -> bool {
        let registers = self.active.len();
        let exists = |r: &Register| usize::from(*r) < registers;
        let all = |mut list: std::slice::Iter<'_, Register>| list.all(exists);
        self.kept.len() == registers
            && registers <= usize::from(Register::MAX) + 1
            && self.states.len() == self.rates.len()
            && all(self.states.iter())
            && all(self.rates.iter())
            && all(self.signs.iter())
            && self.all().all(|op| exists(&op.to) && op.operands().all(|r| exists(&r)))
            && self.all().count().saturating_mul(words) <= LARGEST
    }

    fn all(&self) -> impl Iterator<Item = &Op> {
        let parts = [self.time, self.code, self.output, self.motion, self.slopes];
        parts.into_iter().flatten()
    }
}

/// Marks the registers that have tangents after instructions, where those marked had some before.
pub fn spread(code: &[Op], active: &mut [bool]) {
    for op in code {
        let has = |r: Register| active.get(usize::from(r)).copied().unwrap_or(false);
        let result = match op.action {
            Action::Sign | Action::SignOrOne | Action::Step => false,
            Action::Select => has(op.b) || has(op.c),
            _ => op.operands().any(has),
        };
        if let Some(a) = active.get_mut(usize::from(op.to)) {
            *a = result;
        }
    }
}
