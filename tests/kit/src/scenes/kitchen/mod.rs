//! A kitchen after the paper's figure 5: small things in clusters about an empty middle.

mod chair;
mod crockery;
mod cupboards;
mod groceries;
mod room;
mod stove;
mod table;

use super::shape::{Model, at, stand};
use super::{NamedView, Scene};
use crate::View;
use glam::DVec3;

/// Where the table stands; chairs and what lies on it follow.
const TABLE: DVec3 = DVec3::new(3.3, 0.0, 2.85);

/// The kitchen: 6 m x 2.7 m x 4.5 m.
pub fn kitchen() -> Scene {
    let mut model = Model::default();
    room::room(&mut model);
    cupboards::rows(&mut model);
    stove::stove(&mut model);
    groceries::shelves(&mut model);
    model.within(stand(TABLE, 0.0), |m| {
        table::table(m);
        crockery::laid(m, table::HEIGHT);
        for (x, z, turn) in [
            (-0.55, -0.72, 0.01),
            (0.5, -0.68, -0.02),
            (-0.5, 0.75, 0.49),
            (0.55, 0.7, 0.52),
            (-1.3, 0.05, 0.26),
            (1.45, -0.1, -0.21),
        ] {
            m.within(stand(at(x, 0.0, z), turn), chair::chair);
        }
    });
    let view = |name, eye, at, fov_deg| NamedView {
        name,
        view: View { eye, at, up: [0.0, 1.0, 0.0], fov_deg },
    };
    Scene {
        mesh: model.finish(),
        views: vec![
            view("wide", [0.35, 1.75, 4.2], [3.4, 0.85, 1.2], 68.0),
            view("kitchenBowlView", [2.65, 1.16, 3.4], [3.11, 0.82, 2.82], 24.0),
        ],
    }
}
