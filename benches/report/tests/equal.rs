//! The recursive grid at equal memory and at equal cost, read off a curve.
#![allow(missing_docs)]

use hug_report::selected::curves::{self, COMPARED, Curve, RECURSIVE};
use hug_report::selected::equal::{CostCurve, Reading};

fn curve(points: &[(f64, f64)]) -> CostCurve {
    CostCurve::new(points.iter().copied()).expect("points")
}

fn near(reading: Reading, expected: f64) {
    let Reading::At(value) = reading else { panic!("{reading:?} instead of {expected}") };
    assert!((value / expected - 1.0).abs() < 1e-12, "{value} instead of {expected}");
}

#[test]
fn a_power_is_read_exactly_between_its_points() {
    // cost = 100 / sqrt(memory), a line on logarithmic scales.
    let cost = |m: f64| 100.0 / m.sqrt();
    let curve = curve(&[16.0, 1.0, 4.0].map(|m| (m, cost(m))));
    for memory in [1.0, 1.5, 2.0, 4.0, 9.0, 16.0] {
        near(curve.cost_at(memory), cost(memory));
        near(curve.memory_at(cost(memory)), memory);
    }
}

#[test]
fn nothing_is_read_beyond_the_ends() {
    let curve = curve(&[(1.0, 80.0), (2.0, 40.0), (8.0, 20.0)]);
    assert_eq!(curve.cost_at(0.99), Reading::Below(1.0));
    assert_eq!(curve.cost_at(8.01), Reading::Above(8.0));
    assert_eq!(curve.memory_at(19.9), Reading::Below(20.0));
    assert_eq!(curve.memory_at(80.1), Reading::Above(80.0));
    for reading in [curve.cost_at(0.5), curve.memory_at(1.0), curve.memory_at(1e9)] {
        assert_eq!(reading.at(), None);
    }
}

#[test]
fn the_least_memory_counts_where_the_cost_rises_again() {
    let curve = curve(&[(1.0, 100.0), (2.0, 120.0), (4.0, 30.0), (8.0, 60.0), (16.0, 10.0)]);
    // From 120 to 30 half way on the scale of logarithms.
    near(curve.memory_at(60.0), 8f64.sqrt());
    near(curve.memory_at(30.0), 4.0);
    // It costs 30 with 8 and less on the way from 60 to 10 only.
    let Reading::At(memory) = curve.memory_at(20.0) else { panic!("in range") };
    assert!(memory > 8.0 && memory < 16.0, "{memory}");
    assert_eq!(curve.memory_at(110.0), Reading::Above(100.0));
}

#[test]
fn of_one_size_the_mean_counts() {
    let curve = curve(&[(2.0, 10.0), (2.0, 40.0), (1.0, 80.0), (2.0, 20.0)]);
    near(curve.cost_at(2.0), 20.0);
    near(curve.cost_at(2f64.sqrt()), 40.0);
    near(curve.memory_at(40.0), 2f64.sqrt());
}

#[test]
fn improper_points_are_left_out() {
    let improper = [(0.0, 1.0), (1.0, 0.0), (f64::NAN, 1.0), (1.0, f64::INFINITY)];
    assert!(CostCurve::new(improper).is_none());
    assert!(CostCurve::new([]).is_none());
    let curve = curve(&[improper[0], (3.0, 7.0), improper[3]]);
    near(curve.cost_at(3.0), 7.0);
    near(curve.memory_at(7.0), 3.0);
    assert_eq!(curve.cost_at(1.0), Reading::Below(3.0));
}

#[test]
fn curves_are_notations_with_a_place_for_the_parameter() {
    let recursive: Curve = RECURSIVE.parse().expect("a curve");
    let written: Vec<String> = recursive.members.iter().map(|m| m.1.to_string()).collect();
    assert_eq!(written, ["r1000", "r500", "r200", "r100", "r50", "r20", "r10"]);
    let hug: Curve = "u.f2.ALPHA".parse().expect("a curve");
    assert!(hug.members.iter().any(|m| m.0 == "sqrt2" && m.1.to_string() == "u.f2.sqrt2"));
    let single: Curve = "g28".parse().expect("a curve of one");
    assert_eq!(single.members.len(), 1);
    for wrong in ["u.f9.ALPHA", "gALPHA", "ALPHA", "", "rMAXPMAXP"] {
        assert!(wrong.parse::<Curve>().is_err(), "{wrong}");
    }
    let names = |asked: &[Curve]| -> Vec<String> {
        curves::all(asked).expect("curves").into_iter().map(|c| c.name).collect()
    };
    assert_eq!(names(&[])[1..], COMPARED);
    assert_eq!(names(&[hug.clone(), recursive, hug]), [RECURSIVE, "u.f2.ALPHA"]);
}
