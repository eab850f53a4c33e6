use crate::algebra::BigRational;

/// The numbers behind a picture, exact, in columns.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Numbers {
    /// The name of each column.
    pub columns: Vec<String>,
    /// The rows, each as long as there are columns.
    pub rows: Vec<Vec<BigRational>>,
}

impl Numbers {
    /// No rows yet.
    pub fn new(columns: &[&str]) -> Self {
        Numbers {
            columns: columns.iter().map(|&name| name.to_owned()).collect(),
            rows: Vec::new(),
        }
    }

    /// A column by its name.
    pub fn column(&self, name: &str) -> Option<Vec<&BigRational>> {
        let at = self.columns.iter().position(|own| own == name)?;
        self.rows.iter().map(|row| row.get(at)).collect()
    }
}
