//! What the benchmark programs and the report share; each uses a part of it.

pub mod args;
pub mod cameras;
pub mod clock;
pub mod costs;
pub mod cpu_time;
pub mod figures;
pub mod fit;
pub mod instructions;
pub mod kind;
pub mod load;
pub mod machine;
pub mod named;
pub mod notation;
pub mod obj;
pub mod paper;
pub mod ply;
pub mod ray_sets;
pub mod rounds;
pub mod shade;
pub mod table;
pub mod variation;
