//! One line for each remark, as editors and `grep` read it: `file:line:col: level[code]: message`.

use super::place::one_line;
use super::remark::Remark;

/// The lines of all remarks that no baseline knows.
pub fn short(remarks: &[Remark]) -> String {
    let mut text = String::new();
    for remark in remarks.iter().filter(|remark| !remark.known) {
        let (start, _) = remark.place;
        let place = format!("{}:{}:{}", one_line(&remark.path), start.line, start.column);
        let title = one_line(&remark.title);
        text += &format!("{place}: {}[{}]: {title}\n", remark.level, remark.code);
    }
    text
}
