//! Growth as a power.

/// The exponent p of y = c x^p that fits the points best: least squares on the logarithms.
/// `None` unless two points have different x.
pub fn exponent(points: &[(f64, f64)]) -> Option<f64> {
    let logs: Vec<(f64, f64)> = points.iter().map(|&(x, y)| (x.ln(), y.ln())).collect();
    let n = logs.len() as f64;
    let mean_x = logs.iter().map(|l| l.0).sum::<f64>() / n;
    let mean_y = logs.iter().map(|l| l.1).sum::<f64>() / n;
    let both: f64 = logs.iter().map(|l| (l.0 - mean_x) * (l.1 - mean_y)).sum();
    let squares: f64 = logs.iter().map(|l| (l.0 - mean_x).powi(2)).sum();
    (squares > 0.0).then_some(both / squares)
}
