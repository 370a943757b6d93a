//! Figure 10, and the rendering statistics of figures 20, 22 and 23.

/// A line of the top of figure 10: seconds a call, and the successes of test_1 and test_2.
#[derive(Clone, Copy, Debug)]
pub struct Costs {
    pub name: &'static str,
    /// Ray-polygon test.
    pub t_pi: f64,
    /// Test of a grid's box and setting up of the walk in it.
    pub t_rg_bi: f64,
    /// Next voxel.
    pub t_nc: f64,
    /// %s1, %s2.
    pub successes: [f64; 2],
}

const fn costs(name: &'static str, times: [f64; 3], successes: [f64; 2]) -> Costs {
    let [t_pi, t_rg_bi, t_nc] = times;
    Costs { name, t_pi, t_rg_bi, t_nc, successes }
}

pub const FIGURE_10_TOP: [Costs; 5] = [
    costs("csbc.u.f2.sqrt2", [1.6e-6, 3.2e-5, 8.4e-6], [72.3, 9.35]),
    costs("csbc.u.f3.1", [8.6e-7, 2.9e-5, 9.3e-6], [70.3, 4.91]),
    costs("csbc.r50", [1.1e-6, 4.6e-5, 6.1e-6], [84.4, 6.63]),
    costs("csbc.r500", [2.9e-7, 5.2e-5, 7.1e-6], [87.7, 1.69]),
    costs("csbc.g80", [1.0e-6, 5.0e-5, 4.1e-6], [90.6, 6.29]),
];

/// A line of the bottom of figure 10.
#[derive(Clone, Copy, Debug)]
pub struct Performance {
    pub name: &'static str,
    /// #pit, #bbi, #vt.
    pub calls: [f64; 3],
    pub megabytes: f64,
    pub seconds: f64,
}

const fn performance(
    name: &'static str,
    calls: [f64; 3],
    megabytes: f64,
    seconds: f64,
) -> Performance {
    Performance { name, calls, megabytes, seconds }
}

/// Counted in units: the paper prints millions, thousands and millions.
pub const FIGURE_10_BOTTOM: [Performance; 4] = [
    performance("kit.u.f3.sqrt2", [5.3e6, 509e3, 2e6], 4.0, 57.0),
    performance("kit.u.f2.sqrt2", [5.3e6, 367e3, 2.3e6], 3.63, 47.0),
    performance("kit.r50", [3.9e6, 231e3, 2.9e6], 7.87, 45.0),
    performance("kit.r500", [18e6, 138e3, 2.4e6], 4.38, 86.0),
];

/// A table of rendering statistics, deepest level first.
#[derive(Clone, Copy, Debug)]
pub struct Rendering {
    pub figure: &'static str,
    pub name: &'static str,
    /// %pit, %pi, %(pi / pit), %bbi, %vt.
    pub levels: &'static [[f64; 5]],
    /// #pit, #pi, #bbi, #vt.
    pub sums: [f64; 4],
    pub seconds: f64,
}

pub const FIGURES_20_TO_23: [Rendering; 4] = [
    Rendering {
        figure: "20",
        name: "kit.u.f3.sqrt2",
        levels: &[
            [10.9, 7.61, 2.16, 53.6, 49.7],
            [3.51, 3.74, 3.29, 21.8, 22.2],
            [85.6, 88.7, 3.2, 24.5, 28.1],
        ],
        sums: [5.3e6, 1.6e5, 5.0e5, 2.1e6],
        seconds: 57.0,
    },
    Rendering {
        figure: "20",
        name: "kit.r50",
        levels: &[
            [6e-3, 1e-3, 0.735, 9e-3, 9e-3],
            [0.367, 0.507, 5.05, 1.03, 0.864],
            [20.2, 15.9, 2.87, 44.9, 42.2],
            [79.5, 83.6, 3.84, 54.1, 56.9],
        ],
        sums: [3.9e6, 1.4e5, 2.3e5, 2.9e6],
        seconds: 45.0,
    },
    Rendering {
        figure: "22",
        name: "kitchenBowlView.u.f3.sqrt2",
        levels: &[
            [57.9, 30.9, 1.94, 35.6, 63.5],
            [1.15, 2.03, 6.37, 46.6, 31.4],
            [41.0, 67.0, 5.93, 17.8, 5.11],
        ],
        sums: [10.1e6, 3.6e5, 7e5, 2.4e6],
        seconds: 74.27,
    },
    Rendering {
        figure: "23",
        name: "kitchenBowlView.r50",
        levels: &[
            [0.0; 5],
            [3.86, 3.79, 3.43, 7.45, 14.4],
            [79.4, 59.3, 2.61, 67.1, 81.8],
            [16.7, 36.9, 7.69, 25.5, 3.77],
        ],
        sums: [5.9e6, 2e5, 4.9e5, 3.3e6],
        seconds: 62.73,
    },
];
