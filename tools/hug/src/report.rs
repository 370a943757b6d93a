//! `hug report`: hug-report under another name.

use hug_report::args::Args;

pub fn run(args: &Args) -> Result<(), String> {
    let given: Vec<String> = std::env::args().skip(1).collect();
    let page = hug_report::run::run(args, &format!("hug {}", given.join(" ")))?;
    println!("{}", page.display());
    Ok(())
}
