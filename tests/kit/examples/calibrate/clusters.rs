//! Definition 3: sets whose projections are delta-connected on all three axes.

use crate::overlap::Cell;

/// Splits `members` along x, y and z in turn until every part is connected on each.
pub fn clusters(boxes: &[Cell], members: Vec<u32>, delta: f64) -> Vec<Vec<u32>> {
    let mut done = Vec::new();
    let mut open = vec![(members, 0, 0)];
    while let Some((mut part, axis, connected)) = open.pop() {
        if connected == 3 || part.is_empty() {
            done.extend((!part.is_empty()).then_some(part));
            continue;
        }
        part.sort_by(|&a, &b| {
            let lo = |i: u32| boxes[i as usize].lo[axis];
            lo(a).total_cmp(&lo(b))
        });
        let mut runs: Vec<Vec<u32>> = Vec::new();
        let mut reach = f64::NEG_INFINITY;
        for i in part {
            let b = &boxes[i as usize];
            match runs.last_mut() {
                Some(run) if b.lo[axis] - reach < delta => run.push(i),
                _ => runs.push(vec![i]),
            }
            reach = reach.max(b.hi[axis]);
        }
        let connected = if runs.len() == 1 { connected + 1 } else { 1 };
        open.extend(runs.into_iter().map(|run| (run, (axis + 1) % 3, connected)));
    }
    done
}
