//! The functions of a step in typed instructions of the compiler.

use crate::lower::{Lowering, Num};
use crate::{Op, Register, StepCode};
use cranelift_codegen::ir::{InstBuilder, Value};

/// The body of a function that is being built.
pub struct Body<'a, 'f> {
    pub lowering: Lowering<'a, 'f>,
    pub step: &'a StepCode<'a>,
}

impl<'a, 'f> Body<'a, 'f> {
    fn states(&self) -> std::ops::Range<usize> {
        0..self.step.states.len()
    }

    pub fn read(&mut self, base: Value) -> Vec<Num> {
        self.states().map(|i| self.lowering.load(base, i, true)).collect()
    }

    pub fn write(&mut self, base: Value, x: &[Num]) {
        for (i, x) in x.iter().enumerate() {
            self.lowering.store(base, i, x);
        }
    }

    fn constant(&mut self, c: f64, h: Value) -> Value {
        let c = self.lowering.builder.ins().f64const(c);
        self.lowering.builder.ins().fmul(c, h)
    }

    /// The rates at a state.
    pub fn rates(&mut self, x: &[Num]) -> Vec<Num> {
        for (register, x) in self.step.states.iter().zip(x) {
            self.lowering.set(*register, x.clone());
        }
        for op in self.step.code {
            self.lowering.op(op);
        }
        self.step.rates.iter().map(|r| self.lowering.get(*r)).collect()
    }

    /// Instructions by themselves; all of their results are left by `keep`.
    pub fn segment(&mut self, code: &[Op], keep: impl Fn(&mut Lowering<'a, 'f>, Register)) {
        for op in code {
            self.lowering.op(op);
        }
        for op in code {
            keep(&mut self.lowering, op.to);
        }
    }

    /// x + h·k for each state.
    fn along(&mut self, x: &[Num], k: &[Num], h: Value) -> Vec<Num> {
        let l = &mut self.lowering;
        x.iter()
            .zip(k)
            .map(|(x, k)| {
                let change = l.scale(k, h);
                l.add(x, &change)
            })
            .collect()
    }

    fn sums(&mut self, a: &[Num], b: &[Num]) -> Vec<Num> {
        a.iter().zip(b).map(|(a, b)| self.lowering.add(a, b)).collect()
    }

    /// The rates at the end of the step, with the registers that are to be kept, and the rates before them.
    fn leave(&mut self, x1: &[Num], last: &[Num], written: [Value; 3]) {
        let rates = self.rates(x1);
        self.write(written[0], x1);
        self.write(written[1], &rates);
        for (i, k) in last.iter().enumerate() {
            let value = Num { value: k.value, tangents: None };
            self.lowering.store(written[2], i, &value);
        }
        let computed: Vec<Register> = self.step.code.iter().map(|op: &Op| op.to).collect();
        for r in self.step.states.iter().chain(&computed).filter(|r| self.step.kept[usize::from(**r)]) {
            self.lowering.keep(*r);
        }
    }

    /// The stages of the classical method up to the last: x + h·k₃, and k₁ + 2(k₂ + k₃).
    pub fn last_stage(&mut self, x: &[Num], k1: &[Num], h: Value) -> (Vec<Num>, Vec<Num>) {
        let half = self.constant(0.5, h);
        let at = self.along(x, k1, half);
        let k2 = self.rates(&at);
        let at = self.along(x, &k2, half);
        let k3 = self.rates(&at);
        let last = self.along(x, &k3, h);
        let two = self.lowering.builder.ins().f64const(2.0);
        let middle = self.sums(&k2, &k3);
        let doubled: Vec<Num> = middle.iter().map(|m| self.lowering.scale(m, two)).collect();
        (last, self.sums(k1, &doubled))
    }

    /// From the last stage of the classical method to the end of the step: x + h/6·(sum + k₄), and k₄.
    pub fn end_of_classical(
        &mut self,
        x: &[Num],
        (stage, sum): (&[Num], &[Num]),
        h: Value,
    ) -> (Vec<Num>, Vec<Num>) {
        let k4 = self.rates(stage);
        let all = self.sums(sum, &k4);
        let six = self.lowering.builder.ins().f64const(6.0);
        let sixth = self.lowering.builder.ins().fdiv(h, six);
        (self.along(x, &all, sixth), k4)
    }

    /// The end of a step of Heun's method, x + h/2·(k₁ + k₂), and k₂.
    pub fn end_by_heun(&mut self, x: &[Num], k1: &[Num], h: Value) -> (Vec<Num>, Vec<Num>) {
        let at = self.along(x, k1, h);
        let k2 = self.rates(&at);
        let both = self.sums(k1, &k2);
        let half = self.constant(0.5, h);
        (self.along(x, &both, half), k2)
    }

    /// The stages of the classical method up to the last.
    pub fn first(&mut self, arguments: &[Value]) {
        let [_, x, k, _, h, stage, sum, _] = *arguments else { return };
        let (x, k1) = (self.read(x), self.read(k));
        let (last, sums) = self.last_stage(&x, &k1, h);
        self.write(stage, &last);
        self.write(sum, &sums);
    }

    /// The last stage of the classical method, and the end of the step.
    pub fn second(&mut self, arguments: &[Value]) {
        let [_, x, stage, sum, h, x1, k, last] = *arguments else { return };
        let (x, stage, sum) = (self.read(x), self.read(stage), self.read(sum));
        let (at, k4) = self.end_of_classical(&x, (&stage, &sum), h);
        self.leave(&at, &k4, [x1, k, last]);
    }

    /// A step of Heun's method.
    pub fn heun(&mut self, arguments: &[Value]) {
        let [_, x, k, _, h, x1, rates, last] = *arguments else { return };
        let (x, k1) = (self.read(x), self.read(k));
        let (at, k2) = self.end_by_heun(&x, &k1, h);
        self.leave(&at, &k2, [x1, rates, last]);
    }
}
