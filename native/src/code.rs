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
}

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
