//! Instructions to typed instructions of the compiler, values and tangents.

use crate::{Action, Op, Register};
use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::{InstBuilder, MemFlags, SigRef, Type, Value, types};
use cranelift_frontend::FunctionBuilder;
use std::collections::HashMap;

/// A number in the processor's registers; without tangents where these are 0.
#[derive(Clone)]
pub struct Num {
    pub value: Value,
    /// Two tangents a vector.
    pub tangents: Option<Vec<Value>>,
}

/// What a function has at hand of a register.
#[derive(Clone, Default)]
pub struct Held {
    number: Option<Num>,
    /// Where in memory it is, with whether it has tangents there.
    place: Option<(Value, bool)>,
}

/// Kinds of functions that are called.
#[derive(Clone, Copy)]
pub struct Signatures {
    pub one: SigRef,
    pub two: SigRef,
    pub whole: SigRef,
}

/// The function that is being built, and what its registers hold.
pub struct Lowering<'a, 'f> {
    pub builder: &'a mut FunctionBuilder<'f>,
    /// The address of the registers.
    pub base: Value,
    pub pointer: Type,
    pub tangents: usize,
    pub active: &'a [bool],
    pub signatures: Signatures,
    /// What is at hand of each register.
    pub held: Vec<Held>,
    pub spread: HashMap<Value, Value>,
}

/// Memory that is there, of doubles in no promised alignment beyond a double's.
fn memory() -> MemFlags {
    MemFlags::new().with_notrap()
}

impl Lowering<'_, '_> {
    /// Bytes from the first of many numbers to the one of this number.
    fn offset(&self, number: usize) -> i32 {
        (number * 8 * (1 + self.tangents)) as i32
    }

    /// The number at a place of an array.
    pub fn load(&mut self, base: Value, number: usize, with_tangents: bool) -> Num {
        let offset = self.offset(number);
        let value = self.builder.ins().load(types::F64, memory(), base, offset);
        let pairs = if with_tangents { self.tangents / 2 } else { 0 };
        let pair =
            |j: usize| self.builder.ins().load(types::F64X2, memory(), base, offset + 8 + 16 * j as i32);
        let tangents: Vec<Value> = (0..pairs).map(pair).collect();
        Num { value, tangents: Some(tangents).filter(|t| !t.is_empty()) }
    }

    /// Puts a number at a place of an array, all of its tangents.
    pub fn store(&mut self, base: Value, number: usize, x: &Num) {
        self.store_known(base, number, x);
        if x.tangents.is_none() && self.tangents > 0 {
            let offset = self.offset(number);
            let zero = self.zeros();
            for j in 0..self.tangents / 2 {
                self.builder.ins().store(memory(), zero, base, offset + 8 + 16 * j as i32);
            }
        }
    }

    /// Puts a number where it has no tangents if this one has none.
    fn store_known(&mut self, base: Value, number: usize, x: &Num) {
        let offset = self.offset(number);
        self.builder.ins().store(memory(), x.value, base, offset);
        for (j, pair) in x.tangents.iter().flatten().enumerate() {
            self.builder.ins().store(memory(), *pair, base, offset + 8 + 16 * j as i32);
        }
    }

    /// The number in a register.
    pub fn get(&mut self, r: Register) -> Num {
        let k = usize::from(r);
        if let Some(x) = &self.held[k].number {
            return x.clone();
        }
        let x = match self.held[k].place {
            Some((place, with_tangents)) => self.load(place, 0, with_tangents),
            None => self.load(self.base, k, self.active[k]),
        };
        let place = self.place(r);
        self.held[k] = Held { number: Some(x.clone()), place };
        x
    }

    /// Where in memory a register's number is; none where this function made it.
    fn place(&mut self, r: Register) -> Option<(Value, bool)> {
        let k = usize::from(r);
        let Held { number, place } = &self.held[k];
        if place.is_none() && number.is_none() {
            let offset = i64::from(self.offset(k));
            let place = self.builder.ins().iadd_imm(self.base, offset);
            self.held[k].place = Some((place, self.active[k]));
        }
        self.held[k].place
    }

    /// Puts a number into a register.
    pub fn set(&mut self, r: Register, x: Num) {
        self.held[usize::from(r)] = Held { number: Some(x), place: None };
    }

    /// The place of b where a is positive, else that of c: of numbers that lie in memory none is loaded but the one that
    /// is used, which of a curve's many pieces is one.
    fn chosen_place(&mut self, [a, b, c]: [Register; 3]) -> Option<(Value, bool)> {
        let (Some(b), Some(c)) = (self.place(b), self.place(c)) else { return None };
        let a = self.get(a);
        let zero = self.builder.ins().f64const(0.0);
        let is = self.builder.ins().fcmp(FloatCC::GreaterThan, a.value, zero);
        Some((self.builder.ins().select(is, b.0, c.0), b.1 || c.1))
    }

    /// The number of a register that this function has anything of.
    fn made(&mut self, r: Register) -> Option<Num> {
        let Held { number, place } = &self.held[usize::from(r)];
        (number.is_some() || place.is_some()).then(|| self.get(r))
    }

    /// Leaves what a register holds in memory; without tangents, it may have had some under another sign.
    pub fn keep(&mut self, r: Register) {
        if let Some(x) = self.made(r) {
            self.store(self.base, usize::from(r), &x);
        }
    }

    /// Leaves what a register holds in memory, where it never had other tangents.
    pub fn keep_known(&mut self, r: Register) {
        if let Some(x) = self.made(r) {
            self.store_known(self.base, usize::from(r), &x);
        }
    }

    pub fn zeros(&mut self) -> Value {
        let zero = self.builder.ins().f64const(0.0);
        self.both(zero)
    }

    /// A vector of the same double twice.
    fn both(&mut self, x: Value) -> Value {
        if let Some(v) = self.spread.get(&x) {
            return *v;
        }
        let v = self.builder.ins().splat(types::F64X2, x);
        self.spread.insert(x, v);
        v
    }

    fn scaled(&mut self, x: Option<&Vec<Value>>, by: Value) -> Option<Vec<Value>> {
        let x = x?;
        let by = self.both(by);
        Some(x.iter().map(|t| self.builder.ins().fmul(by, *t)).collect())
    }

    fn sum(&mut self, x: Option<Vec<Value>>, y: Option<Vec<Value>>) -> Option<Vec<Value>> {
        match (x, y) {
            (Some(x), Some(y)) => {
                Some(x.iter().zip(&y).map(|(x, y)| self.builder.ins().fadd(*x, *y)).collect())
            }
            (x, y) => x.or(y),
        }
    }

    fn negated(&mut self, x: Option<&Vec<Value>>) -> Option<Vec<Value>> {
        Some(x?.iter().map(|t| self.builder.ins().fneg(*t)).collect())
    }

    /// x + y
    pub fn add(&mut self, x: &Num, y: &Num) -> Num {
        let value = self.builder.ins().fadd(x.value, y.value);
        Num { value, tangents: self.sum(x.tangents.clone(), y.tangents.clone()) }
    }

    fn sub(&mut self, x: &Num, y: &Num) -> Num {
        let value = self.builder.ins().fsub(x.value, y.value);
        let tangents = match (&x.tangents, &y.tangents) {
            (Some(x), Some(y)) => {
                Some(x.iter().zip(y).map(|(x, y)| self.builder.ins().fsub(*x, *y)).collect())
            }
            (x, None) => x.clone(),
            (None, y) => self.negated(y.as_ref()),
        };
        Num { value, tangents }
    }

    fn mul(&mut self, x: &Num, y: &Num) -> Num {
        let value = self.builder.ins().fmul(x.value, y.value);
        let by_x = self.scaled(x.tangents.as_ref(), y.value);
        let by_y = self.scaled(y.tangents.as_ref(), x.value);
        Num { value, tangents: self.sum(by_x, by_y) }
    }

    /// c·x for a plain c.
    pub fn scale(&mut self, x: &Num, c: Value) -> Num {
        let value = self.builder.ins().fmul(c, x.value);
        Num { value, tangents: self.scaled(x.tangents.as_ref(), c) }
    }

    fn div(&mut self, x: &Num, y: &Num) -> Num {
        let value = self.builder.ins().fdiv(x.value, y.value);
        let by_x = x.tangents.is_some().then(|| {
            let one = self.builder.ins().f64const(1.0);
            self.builder.ins().fdiv(one, y.value)
        });
        let by_x = by_x.and_then(|slope| self.scaled(x.tangents.as_ref(), slope));
        let by_y = y.tangents.is_some().then(|| {
            let negative = self.builder.ins().fneg(value);
            self.builder.ins().fdiv(negative, y.value)
        });
        let by_y = by_y.and_then(|slope| self.scaled(y.tangents.as_ref(), slope));
        Num { value, tangents: self.sum(by_x, by_y) }
    }

    fn select(&mut self, a: &Num, b: &Num, c: &Num) -> Num {
        let zero = self.builder.ins().f64const(0.0);
        let is = self.builder.ins().fcmp(FloatCC::GreaterThan, a.value, zero);
        let value = self.builder.ins().select(is, b.value, c.value);
        if b.tangents.is_none() && c.tangents.is_none() {
            return Num { value, tangents: None };
        }
        let zeros = vec![self.zeros(); self.tangents / 2];
        let (b, c) = (b.tangents.as_ref().unwrap_or(&zeros), c.tangents.as_ref().unwrap_or(&zeros));
        let chosen = b.iter().zip(c).map(|(b, c)| self.builder.ins().select(is, *b, *c)).collect();
        Num { value, tangents: Some(chosen) }
    }

    /// 1 where a stands so to 0, `below` where it is below, else 0.
    fn side(&mut self, a: &Num, above: FloatCC, below: f64) -> Num {
        let [zero, one, below] = [0.0, 1.0, below].map(|x| self.builder.ins().f64const(x));
        let is_below = self.builder.ins().fcmp(FloatCC::LessThan, a.value, zero);
        let is_above = self.builder.ins().fcmp(above, a.value, zero);
        let rest = self.builder.ins().select(is_below, below, zero);
        Num { value: self.builder.ins().select(is_above, one, rest), tangents: None }
    }

    /// √a, whose slope is 1/(2√a), 0 where that has no end.
    fn root(&mut self, a: &Num) -> Num {
        let value = self.builder.ins().sqrt(a.value);
        let slope = a.tangents.is_some().then(|| {
            let [zero, half] = [0.0, 0.5].map(|x| self.builder.ins().f64const(x));
            let slope = self.builder.ins().fdiv(half, value);
            let is_level = self.builder.ins().fcmp(FloatCC::Equal, value, zero);
            self.builder.ins().select(is_level, zero, slope)
        });
        Num { value, tangents: slope.and_then(|s| self.scaled(a.tangents.as_ref(), s)) }
    }

    fn call(&mut self, signature: SigRef, address: usize, x: &[Value]) -> Value {
        let address = self.builder.ins().iconst(self.pointer, address as i64);
        let call = self.builder.ins().call_indirect(signature, address, x);
        self.builder.inst_results(call)[0]
    }

    /// Does one instruction.
    pub fn op(&mut self, op: &Op) {
        if matches!(op.action, Action::Select)
            && let Some(place) = self.chosen_place([op.a, op.b, op.c])
        {
            self.held[usize::from(op.to)] = Held { number: None, place: Some(place) };
            return;
        }
        let a = self.get(op.a);
        let Signatures { one, two, whole } = self.signatures;
        let result = match op.action {
            Action::Add => {
                let b = self.get(op.b);
                self.add(&a, &b)
            }
            Action::Sub => {
                let b = self.get(op.b);
                self.sub(&a, &b)
            }
            Action::Mul => {
                let b = self.get(op.b);
                self.mul(&a, &b)
            }
            Action::Div => {
                let b = self.get(op.b);
                self.div(&a, &b)
            }
            Action::MulAdd => {
                let (b, c) = (self.get(op.b), self.get(op.c));
                let product = self.mul(&a, &b);
                self.add(&product, &c)
            }
            Action::MulSub => {
                let (b, c) = (self.get(op.b), self.get(op.c));
                let product = self.mul(&a, &b);
                self.sub(&c, &product)
            }
            Action::Negative => {
                let value = self.builder.ins().fneg(a.value);
                Num { value, tangents: self.negated(a.tangents.as_ref()) }
            }
            Action::Square => self.mul(&a, &a),
            Action::Cube => {
                let square = self.mul(&a, &a);
                self.mul(&square, &a)
            }
            Action::Select => {
                let (b, c) = (self.get(op.b), self.get(op.c));
                self.select(&a, &b, &c)
            }
            Action::One(f, slope) => {
                let value = self.call(one, f as usize, &[a.value]);
                let slope = a.tangents.is_some().then(|| self.call(two, slope as usize, &[a.value, value]));
                Num { value, tangents: slope.and_then(|s| self.scaled(a.tangents.as_ref(), s)) }
            }
            Action::Two(f, by_a, by_b) => {
                let b = self.get(op.b);
                let value = self.call(two, f as usize, &[a.value, b.value]);
                let mut part = |x: &Num, slope: extern "C" fn(f64, f64) -> f64| {
                    let slope =
                        x.tangents.is_some().then(|| self.call(two, slope as usize, &[a.value, b.value]));
                    slope.and_then(|s| self.scaled(x.tangents.as_ref(), s))
                };
                let (x, y) = (part(&a, by_a), part(&b, by_b));
                Num { value, tangents: self.sum(x, y) }
            }
            Action::Whole(f, slope) => {
                let n = self.builder.ins().iconst(types::I32, i64::from(op.b as i16));
                let value = self.call(whole, f as usize, &[a.value, n]);
                let slope = a.tangents.is_some().then(|| self.call(whole, slope as usize, &[a.value, n]));
                Num { value, tangents: slope.and_then(|s| self.scaled(a.tangents.as_ref(), s)) }
            }
            Action::Sign => self.side(&a, FloatCC::GreaterThan, -1.0),
            Action::SignOrOne => self.side(&a, FloatCC::GreaterThanOrEqual, -1.0),
            Action::Step => self.side(&a, FloatCC::GreaterThanOrEqual, 0.0),
            Action::Sqrt => self.root(&a),
        };
        self.set(op.to, result);
    }
}
