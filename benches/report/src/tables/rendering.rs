//! Figures 20, 22 and 23: what a picture costs, level by level.
