//! An office building in the paper's two forms: its walls alone, and one furnished floor.

mod chair;
mod desk;
mod desktop;
mod office;
mod phone;
mod shelf;
mod storey;

use super::shape::{Model, at, stand};
use super::{NamedView, Scene};
use crate::View;
use crate::random::Random;

const STREAM: u64 = 22;
/// The length of each floor's first slab, of two.
const SLAB_OF_WALLS: f64 = 40.0;
const SLAB_OF_FLOOR: f64 = 48.0;
const STOREYS: u32 = 6;

/// "CSB walls": six storeys without furniture.
pub fn building_walls() -> Scene {
    let mut model = Model::default();
    for number in 0..STOREYS {
        let height = storey::HEIGHT * f64::from(number);
        model.within(stand(at(0.0, height, 0.0), 0.0), |m| {
            storey::storey(m, SLAB_OF_WALLS);
            if number + 1 < STOREYS {
                storey::stairs(m);
            }
        });
    }
    let roof = storey::HEIGHT * f64::from(STOREYS);
    model.within(stand(at(0.0, roof, 0.0), 0.0), |m| storey::slabs(m, SLAB_OF_WALLS));
    Scene {
        mesh: model.finish(),
        views: vec![
            view("corridor", [1.0, 8.9, 7.0], [30.0, 8.5, 7.1], 70.0),
            view("room", [5.2, 1.7, 5.6], [8.5, 1.5, 0.5], 75.0),
        ],
    }
}

/// "CSB 3rd floor": one storey, furnished.
pub fn building() -> Scene {
    let mut model = Model::default();
    let mut random = Random::stream(STREAM);
    storey::storey(&mut model, SLAB_OF_FLOOR);
    for room in 0..storey::ROOMS {
        let x = storey::ROOM_WIDTH * (room as f64 + 0.5);
        // In a room's own coordinates its window is at z = 0 and its door at positive z.
        let south = stand(at(x, 0.0, 0.0), 0.0);
        let north = stand(at(x, 0.0, storey::DEPTH), 0.5);
        for (place, meeting) in [(south, room % 3 == 2), (north, room % 4 == 2)] {
            model.within(place, |m| match meeting {
                true => office::meeting_room(m, &mut random),
                false => office::office(m, &mut random),
            });
        }
    }
    model.within(stand(at(0.0, storey::HEIGHT, 0.0), 0.0), |m| {
        storey::slabs(m, SLAB_OF_FLOOR);
    });
    Scene {
        mesh: model.finish(),
        views: vec![
            view("office", [8.9, 1.75, 5.4], [6.4, 0.85, 1.2], 70.0),
            view("desk", [6.5, 1.35, 2.7], [6.1, 0.8, 1.5], 60.0),
            view("corridor", [1.0, 1.7, 7.0], [30.0, 1.4, 7.1], 70.0),
        ],
    }
}

fn view(name: &'static str, eye: [f32; 3], at: [f32; 3], fov_deg: f32) -> NamedView {
    NamedView { name, view: View { eye, at, up: [0.0, 1.0, 0.0], fov_deg } }
}
