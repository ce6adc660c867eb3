use super::*;

/// r_i = y_i − a e^(−b t_i), with a wall beyond which it cannot be computed.
struct Decay {
    wall: f64,
}

impl Decay {
    fn rows(&self, x: &[f64]) -> (Vec<f64>, Vec<f64>, Vec<f64>) {
        let time = (0..50).map(|i| 0.1 * f64::from(i));
        let wall = self.wall;
        let mut rows = (Vec::new(), Vec::new(), Vec::new());
        for t in time {
            let e = (-x[1] * t).exp();
            let r = x[0] * e - 3.0 * (-0.7 * t).exp();
            rows.0.push(if x[1] > wall { f64::NAN } else { r });
            rows.1.push(e);
            rows.2.push(-x[0] * t * e);
        }
        rows
    }
}

impl Problem for Decay {
    fn unknowns(&self) -> usize {
        2
    }
    fn sum_of_squares(&self, x: &[f64]) -> Result<f64> {
        Ok(self.rows(x).0.iter().map(|r| r * r).sum())
    }
    fn linearise(&self, x: &[f64]) -> Result<Triangle> {
        let (r, a, b) = self.rows(x);
        let mut t = Triangle::new(2);
        t.push(&[&a, &b], &r);
        Ok(t)
    }
}

#[test]
fn finds_the_decay_past_a_wall_of_failures() {
    let wide = Range { min: 1e-3, max: 1e3 };
    let least =
        minimise(&Decay { wall: 0.75 }, &[1.0, 0.02], &[Range::FREE, wide], Stopping::default()).unwrap();
    assert!((least.x[0] - 3.0).abs() < 1e-6 && (least.x[1] - 0.7).abs() < 1e-6, "{least:?}");
}

#[test]
fn stops_at_a_bound_with_the_rest_at_its_conditional_optimum() {
    let bounded = Range { min: 0.01, max: 0.5 };
    let least =
        minimise(&Decay { wall: 9.0 }, &[1.0, 0.1], &[Range::FREE, bounded], Stopping::default()).unwrap();
    assert_eq!(least.at_bound, [None, Some(Side::Upper)]);
    // With b = ½ the best a is Σ y e / Σ e².
    let (mut ye, mut ee) = (0.0, 0.0);
    for t in (0..50).map(|i| 0.1 * f64::from(i)) {
        let e = (-0.5 * t).exp();
        ye += 3.0 * (-0.7 * t).exp() * e;
        ee += e * e;
    }
    assert!((least.x[0] - ye / ee).abs() < 1e-6, "{least:?}");
}

#[test]
fn a_step_that_would_leave_the_box_at_several_bounds_still_goes_down() {
    // ‖J x + r‖² with columns so alike that the free minimum lies far outside the box.
    struct Alike;
    impl Problem for Alike {
        fn unknowns(&self) -> usize {
            2
        }
        fn sum_of_squares(&self, x: &[f64]) -> Result<f64> {
            self.linearise(x).map(|t| t.sum_of_squares())
        }
        fn linearise(&self, x: &[f64]) -> Result<Triangle> {
            let (a, b) = ([1.0, 1.0, 1.0], [1.0, 1.01, 0.99]);
            let r: Vec<f64> = (0..3).map(|i| a[i] * x[0] + b[i] * x[1] - [1.0, 3.0, -2.0][i]).collect();
            let mut t = Triangle::new(2);
            t.push(&[&a, &b], &r);
            Ok(t)
        }
    }
    let ranges = [Range { min: 0.0, max: 4.0 }; 2];
    let least = minimise(&Alike, &[1.0, 0.5], &ranges, Stopping::default()).unwrap();
    // The box's minimum lies on x₀ = 0: x₁ = Σ b y / Σ b².
    let best = (1.0 + 3.03 - 1.98) / (1.0 + 1.01_f64.powi(2) + 0.99_f64.powi(2));
    assert!(least.x[0].abs() < 1e-9 && (least.x[1] - best).abs() < 1e-6, "{least:?}");
}

#[test]
fn a_start_that_cannot_be_computed_is_an_error() {
    let wide = Range { min: 1e-3, max: 1e3 };
    assert!(minimise(&Decay { wall: 0.1 }, &[1.0, 0.5], &[Range::FREE, wide], Stopping::default()).is_err());
}
