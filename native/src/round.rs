//! One round of a march: a step, a look at whether it may stand, and what is written down after it.

use crate::body::Body;
use crate::lower::Num;
use crate::{BEGIN, JUMP, MarchCode, Method, Register, Switch, TOO_LARGE};
use cranelift_codegen::ir::condcodes::{FloatCC, IntCC};
use cranelift_codegen::ir::{Block, BlockArg, InstBuilder, MemFlags, Value, types};

/// Where a march stands: the number of steps taken, the addresses of the next step's length, rows and mark, of the next
/// jump's row, and of the next entry of each list.
#[derive(Clone)]
struct At {
    taken: Value,
    h: Value,
    rows: Value,
    jumps: Value,
    mark: Value,
    lists: Vec<Value>,
}

impl At {
    fn values(&self) -> Vec<BlockArg> {
        let own = [self.taken, self.h, self.rows, self.jumps, self.mark];
        own.into_iter().chain(self.lists.iter().copied()).map(BlockArg::from).collect()
    }

    fn of(values: &[Value]) -> Self {
        let [taken, h, rows, jumps, mark, ..] = *values else { unreachable!("five and the lists") };
        Self { taken, h, rows, jumps, mark, lists: values[5..].to_vec() }
    }
}

/// A step that was tried.
struct Tried {
    x1: Vec<Num>,
    k1: Vec<Num>,
    /// The rates at its end before the last.
    last: Vec<Num>,
    /// What the embedded error weighs, of a step h.
    weight: Value,
}

fn there() -> MemFlags {
    MemFlags::new().with_notrap()
}

impl Body<'_, '_> {
    /// The loop over the steps, with the arguments of a march.
    pub fn march(&mut self, code: &MarchCode<'_>, arguments: &[Value]) {
        let [_, x, k, h, rows, jumps, mark, measures, lists, count] = *arguments else { return };
        let b = &mut *self.lowering.builder;
        let pointer = self.lowering.pointer;
        let taken = b.ins().iconst(types::I64, 0);
        let lists =
            (0..code.written.len()).map(|i| b.ins().load(pointer, there(), lists, 8 * i as i32)).collect();
        let begin = At { taken, h, rows, jumps, mark, lists };
        let (head, end) = (self.block_of(&begin), self.lowering.builder.create_block());
        let b = &mut *self.lowering.builder;
        let result = b.append_block_param(end, types::I64);
        b.ins().jump(head, &begin.values());
        let at = self.enter(head);
        let is_left = self.lowering.builder.ins().icmp(IntCC::SignedLessThan, at.taken, count);
        self.go_on_if(is_left, (end, at.taken));
        let mark = self.lowering.builder.ins().uload16(types::I32, there(), at.mark, 0);
        let at = if code.jumps { self.jump(code, (mark, at), (x, k), end) } else { at };
        let tried = self.try_step(code, &at, (x, k));
        let good = self.may_stand(code.switches, &tried);
        self.go_on_if(good, (end, at.taken));
        self.measure(&tried, measures);
        self.write(x, &tried.x1);
        self.write(k, &tried.k1);
        let next = self.finish(code, (mark, &at));
        let b = &mut *self.lowering.builder;
        b.ins().jump(head, &next.values());
        b.seal_block(head);
        b.switch_to_block(end);
        b.seal_block(end);
        b.ins().return_(&[result]);
    }

    /// Ends the march with the steps taken unless something holds.
    fn go_on_if(&mut self, holds: Value, (end, taken): (Block, Value)) {
        let b = &mut *self.lowering.builder;
        let on = b.create_block();
        b.ins().brif(holds, on, &[], end, &[BlockArg::from(taken)]);
        b.switch_to_block(on);
        b.seal_block(on);
    }

    /// What a jump at the begin of a step asks for, if there is one: the rates anew, and entries.
    fn jump(
        &mut self,
        code: &MarchCode<'_>,
        (mark, at): (Value, At),
        (x, k): (Value, Value),
        end: Block,
    ) -> At {
        let after = self.block_of(&at);
        let b = &mut *self.lowering.builder;
        let here = b.create_block();
        let asked = b.ins().band_imm(mark, i64::from(JUMP));
        b.ins().brif(asked, here, &[], after, &at.values());
        b.switch_to_block(here);
        b.seal_block(here);
        // what stands in this block alone is not at hand behind it
        let (held, spread) = (self.lowering.held.clone(), self.lowering.spread.clone());
        self.load_row(code.loaded, at.jumps, 0);
        let x = self.read(x);
        let rates = self.rates(&x);
        let good = self.lowering.builder.ins().iconst(types::I8, 1);
        let good = self.are_right(code.switches, good);
        self.go_on_if(good, (end, at.taken));
        self.write(k, &rates);
        let begins = self.lowering.builder.ins().ushr_imm(mark, i64::from(BEGIN));
        let mut next = self.write_entries(code, (begins, at));
        next.jumps = self.lowering.builder.ins().iadd_imm(next.jumps, 8 * code.loaded.len() as i64);
        self.lowering.builder.ins().jump(after, &next.values());
        (self.lowering.held, self.lowering.spread) = (held, spread);
        let at = self.enter(after);
        self.lowering.builder.seal_block(after);
        at
    }

    /// A block that begins where a march stands.
    fn block_of(&mut self, at: &At) -> Block {
        let b = &mut *self.lowering.builder;
        let block = b.create_block();
        b.append_block_param(block, types::I64);
        for _ in 0..4 + at.lists.len() {
            b.append_block_param(block, self.lowering.pointer);
        }
        block
    }

    fn enter(&mut self, block: Block) -> At {
        let b = &mut *self.lowering.builder;
        b.switch_to_block(block);
        At::of(b.block_params(block))
    }

    /// Loads the row of a stage, and does what a new time asks for.
    fn load_row(&mut self, loaded: &[Register], rows: Value, stage: usize) {
        for (j, register) in loaded.iter().enumerate() {
            let place = 8 * (stage * loaded.len() + j) as i32;
            let value = self.lowering.builder.ins().load(types::F64, there(), rows, place);
            self.lowering.set(*register, Num { value, tangents: None });
        }
        for op in self.step.time {
            self.lowering.op(op);
        }
    }

    fn try_step(&mut self, code: &MarchCode<'_>, at: &At, (x, k): (Value, Value)) -> Tried {
        let h = self.lowering.builder.ins().load(types::F64, there(), at.h, 0);
        let (x, k1) = (self.read(x), self.read(k));
        self.load_row(code.loaded, at.rows, 0);
        let (x1, last, parts) = if self.step.method == Method::Classical {
            let (stage, sum) = self.last_stage(&x, &k1, h);
            self.load_row(code.loaded, at.rows, 1);
            let (x1, k4) = self.end_of_classical(&x, (&stage, &sum), h);
            (x1, k4, 6.0)
        } else {
            let (x1, k2) = self.end_by_heun(&x, &k1, h);
            (x1, k2, 2.0)
        };
        let k1 = self.rates(&x1);
        let parts = self.lowering.builder.ins().f64const(parts);
        Tried { x1, k1, last, weight: self.lowering.builder.ins().fdiv(h, parts) }
    }

    /// Whether every state is still a number of some size, every rate finite where switches look at it, and every switch
    /// right.
    fn may_stand(&mut self, switches: &[Switch], tried: &Tried) -> Value {
        let b = &mut *self.lowering.builder;
        let mut good = b.ins().iconst(types::I8, 1);
        let limit = b.ins().f64const(TOO_LARGE);
        let endless = b.ins().f64const(f64::INFINITY);
        for x in &tried.x1 {
            let size = b.ins().fabs(x.value);
            let is = b.ins().fcmp(FloatCC::LessThanOrEqual, size, limit);
            good = b.ins().band(good, is);
        }
        for k in tried.k1.iter().filter(|_| !switches.is_empty()) {
            let size = b.ins().fabs(k.value);
            let is = b.ins().fcmp(FloatCC::LessThan, size, endless);
            good = b.ins().band(good, is);
        }
        self.are_right(switches, good)
    }

    /// Whether something holds and every switch is right.
    fn are_right(&mut self, switches: &[Switch], mut good: Value) -> Value {
        for switch in switches {
            let is = self.is_right(*switch);
            good = self.lowering.builder.ins().band(good, is);
        }
        good
    }

    /// Whether a guard g has the sign s of its switch: g·s ≥ 0, or −|g| ≥ 0 where s is 0.
    fn is_right(&mut self, switch: Switch) -> Value {
        let (g, s) = (self.lowering.get(switch.guard).value, self.lowering.get(switch.sign).value);
        let b = &mut *self.lowering.builder;
        let zero = b.ins().f64const(0.0);
        let product = b.ins().fmul(g, s);
        let size = b.ins().fabs(g);
        let off = b.ins().fneg(size);
        let is_zero = b.ins().fcmp(FloatCC::Equal, s, zero);
        let margin = b.ins().select(is_zero, off, product);
        let needed = if switch.is_strict { FloatCC::GreaterThan } else { FloatCC::GreaterThanOrEqual };
        b.ins().fcmp(needed, margin, zero)
    }

    /// Adds the embedded errors, and widens the ranges of the states.
    fn measure(&mut self, tried: &Tried, measures: Value) {
        let n = tried.x1.len();
        let b = &mut *self.lowering.builder;
        for i in 0..n {
            let [sum, low, high] = [i, n + i, 2 * n + i].map(|at| 8 * at as i32);
            let [x, k, last] = [tried.x1[i].value, tried.k1[i].value, tried.last[i].value];
            let difference = b.ins().fsub(last, k);
            let size = b.ins().fabs(difference);
            let error = b.ins().fmul(tried.weight, size);
            let before = b.ins().load(types::F64, there(), measures, sum);
            let after = b.ins().fadd(before, error);
            b.ins().store(there(), after, measures, sum);
            for (place, beyond) in [(low, FloatCC::LessThan), (high, FloatCC::GreaterThan)] {
                let before = b.ins().load(types::F64, there(), measures, place);
                let is = b.ins().fcmp(beyond, x, before);
                let after = b.ins().select(is, x, before);
                b.ins().store(there(), after, measures, place);
            }
        }
    }

    /// Moves held registers on, writes the entries that are asked for, and gives where the march stands then.
    fn finish(&mut self, code: &MarchCode<'_>, (mark, at): (Value, &At)) -> At {
        let mut moved = Vec::new();
        for (held, next) in code.held {
            let value = self.lowering.get(*next);
            self.lowering.set(*held, value.clone());
            moved.push((*held, value));
        }
        let mut next = at.clone();
        let b = &mut *self.lowering.builder;
        let ends = b.ins().band_imm(mark, i64::from(JUMP - 1));
        next.taken = b.ins().iadd_imm(at.taken, 1);
        next.h = b.ins().iadd_imm(at.h, 8);
        next.mark = b.ins().iadd_imm(at.mark, 2);
        next.rows = b.ins().iadd_imm(at.rows, 8 * (code.loaded.len() * self.step.method.stages()) as i64);
        let next = self.write_entries(code, (ends, next));
        // a chosen number may still have been in the place of a held one
        for (held, value) in moved {
            self.lowering.store(self.lowering.base, usize::from(held), &value);
        }
        next
    }

    /// Writes the entries of the lists whose bits are in the mark.
    fn write_entries(&mut self, code: &MarchCode<'_>, (mark, at): (Value, At)) -> At {
        let after = self.block_of(&at);
        let outputs = self.lowering.builder.create_block();
        let b = &mut *self.lowering.builder;
        b.ins().brif(mark, outputs, &[], after, &at.values());
        b.switch_to_block(outputs);
        b.seal_block(outputs);
        // what stands in this block alone is not at hand behind it
        let (held, spread) = (self.lowering.held.clone(), self.lowering.spread.clone());
        for op in self.step.output {
            self.lowering.op(op);
        }
        let entries: Vec<Vec<Num>> =
            code.written.iter().map(|list| list.iter().map(|r| self.lowering.get(*r)).collect()).collect();
        self.lowering.zeros();
        let mut at = at;
        for (i, entry) in entries.iter().enumerate() {
            at.lists[i] = self.write_entry(entry, (mark, i), at.lists[i]);
        }
        self.lowering.builder.ins().jump(after, &at.values());
        (self.lowering.held, self.lowering.spread) = (held, spread);
        let at = self.enter(after);
        self.lowering.builder.seal_block(after);
        at
    }

    /// Writes an entry where its bit is in the mark; gives the address of the next one.
    fn write_entry(&mut self, entry: &[Num], (mark, bit): (Value, usize), list: Value) -> Value {
        let pointer = self.lowering.pointer;
        let b = &mut *self.lowering.builder;
        let (here, after) = (b.create_block(), b.create_block());
        let next = b.append_block_param(after, pointer);
        let asked = b.ins().band_imm(mark, 1 << bit);
        b.ins().brif(asked, here, &[], after, &[BlockArg::from(list)]);
        b.switch_to_block(here);
        b.seal_block(here);
        for (j, number) in entry.iter().enumerate() {
            self.lowering.store(list, j, number);
        }
        let bytes = 8 * (entry.len() * (1 + self.lowering.tangents)) as i64;
        let b = &mut *self.lowering.builder;
        let beyond = b.ins().iadd_imm(list, bytes);
        b.ins().jump(after, &[BlockArg::from(beyond)]);
        b.switch_to_block(after);
        b.seal_block(after);
        next
    }
}
