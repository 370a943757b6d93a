//! Markdown tables that can also be read as they are.

/// A table whose first column is text and whose others are figures.
pub struct Table {
    rows: Vec<Vec<String>>,
}

impl Table {
    pub fn new(head: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self { rows: vec![head.into_iter().map(Into::into).collect()] }
    }

    pub fn row(&mut self, cells: impl IntoIterator<Item = impl Into<String>>) {
        self.rows.push(cells.into_iter().map(Into::into).collect());
    }

    pub fn print(&self) {
        let widths: Vec<usize> = (0..self.rows[0].len())
            .map(|column| {
                let cells = self.rows.iter().filter_map(|row| row.get(column));
                cells.map(|cell| cell.chars().count()).max().unwrap_or(0).max(3)
            })
            .collect();
        for (number, row) in self.rows.iter().enumerate() {
            println!("|{}|", row.iter().zip(&widths).enumerate().map(cell).collect::<String>());
            if number == 0 {
                println!("|{}|", widths.iter().enumerate().map(rule).collect::<String>());
            }
        }
        println!();
    }
}

/// Between cells, not before the first.
fn bar(column: usize) -> &'static str {
    if column == 0 { "" } else { "|" }
}

fn cell((column, (text, &width)): (usize, (&String, &usize))) -> String {
    let bar = bar(column);
    if column == 0 { format!(" {text:<width$} ") } else { format!("{bar} {text:>width$} ") }
}

fn rule((column, &width): (usize, &usize)) -> String {
    let line = "-".repeat(width);
    if column == 0 { format!(" {line} ") } else { format!("{} {line}:", bar(column)) }
}
