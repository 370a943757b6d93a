//! Tables: rounded on the page, whole in the CSV file.

use crate::run::TABLES;
use maud::{Markup, html};
use std::path::Path;

#[derive(Clone, Debug)]
pub enum Cell {
    Text(String),
    Number(f64),
    Count(u64),
    /// Nothing to say.
    None,
}

impl From<&str> for Cell {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<f64> for Cell {
    fn from(x: f64) -> Self {
        Self::Number(x)
    }
}

impl From<u64> for Cell {
    fn from(n: u64) -> Self {
        Self::Count(n)
    }
}

impl<T: Into<Self>> From<Option<T>> for Cell {
    fn from(cell: Option<T>) -> Self {
        cell.map_or(Self::None, Into::into)
    }
}

/// Three significant digits or so, as in the paper.
pub fn number(x: f64) -> String {
    match x.abs() {
        0.0 => "0".into(),
        a if !a.is_finite() => "-".into(),
        a if a < 0.001 => format!("{x:.1e}"),
        a if a < 0.1 => format!("{x:.4}"),
        a if a < 10.0 => format!("{x:.2}"),
        a if a < 1000.0 => format!("{x:.1}"),
        a if a < 1e6 => format!("{x:.0}"),
        _ => format!("{x:.2e}"),
    }
}

/// A whole number in groups of three digits.
pub fn count(n: u64) -> String {
    let digits = n.to_string();
    let groups: Vec<&str> = digits
        .as_bytes()
        .rchunks(3)
        .rev()
        .map(|group| std::str::from_utf8(group).unwrap_or_default())
        .collect();
    groups.join(",")
}

impl Cell {
    fn page(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Number(x) => number(*x),
            Self::Count(n) => count(*n),
            Self::None => String::new(),
        }
    }

    fn file(&self) -> String {
        match self {
            Self::Text(text) => text.clone(),
            Self::Number(x) => x.to_string(),
            Self::Count(n) => n.to_string(),
            Self::None => String::new(),
        }
    }
}

/// One table.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The CSV file's name without its ending.
    pub file: String,
    pub title: String,
    /// How to read it; may be empty.
    pub note: String,
    head: Vec<String>,
    rows: Vec<Vec<Cell>>,
}

impl Sheet {
    pub fn new(file: impl Into<String>, title: impl Into<String>, head: &[&str]) -> Self {
        Self {
            file: file.into(),
            title: title.into(),
            note: String::new(),
            head: head.iter().map(|&name| name.to_owned()).collect(),
            rows: Vec::new(),
        }
    }

    pub fn noted(mut self, note: impl Into<String>) -> Self {
        self.note = note.into();
        self
    }

    pub fn row(&mut self, cells: impl IntoIterator<Item = Cell>) {
        let mut row: Vec<Cell> = cells.into_iter().collect();
        row.resize(self.head.len(), Cell::None);
        self.rows.push(row);
    }

    /// Whether a column is of words.
    fn texts(&self, column: usize) -> bool {
        self.rows.iter().any(|row| matches!(row[column], Cell::Text(_)))
    }

    pub fn write(&self, folder: &Path) -> Result<(), String> {
        let path = folder.join(format!("{}.csv", self.file));
        let failed = |error: csv::Error| format!("{}: {error}", path.display());
        let mut file = csv::Writer::from_path(&path).map_err(failed)?;
        file.write_record(&self.head).map_err(failed)?;
        for row in &self.rows {
            file.write_record(row.iter().map(Cell::file)).map_err(failed)?;
        }
        file.flush().map_err(|error| format!("{}: {error}", path.display()))
    }

    pub fn page(&self) -> Markup {
        html! {
            figure.table {
                figcaption {
                    (self.title) " "
                    a href={ (TABLES) "/" (self.file) ".csv" } { "CSV" }
                }
                @if !self.note.is_empty() { p.note { (self.note) } }
                div.scroll { table {
                    thead { tr { @for (column, name) in self.head.iter().enumerate() {
                        th.text[self.texts(column)] { (name) }
                    } } }
                    tbody {
                        @for row in &self.rows {
                            tr { @for cell in row {
                                @match cell {
                                    Cell::Text(text) => td.text { (text) },
                                    _ => td { (cell.page()) },
                                }
                            } }
                        }
                    }
                } }
            }
        }
    }
}
