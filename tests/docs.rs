//! What the documents say of programs, and programs that stand in them.
#![allow(missing_docs)]
#![cfg(feature = "capi")]

mod common;

use common::native::{library, require_packages, root, run, target};
use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

fn read(file: &str) -> String {
    fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// The first block of code in this language that has these words.
fn block(document: &str, language: &str, words: &str) -> String {
    let text = read(document);
    let start = format!("```{language}\n");
    let blocks = text.split(&start).skip(1).filter_map(|rest| rest.split("```").next());
    let found = blocks.into_iter().find(|block| block.contains(words));
    found.unwrap_or_else(|| panic!("{document}: no {language} with {words}")).to_owned()
}

#[test]
fn the_programs_of_the_readme_print_what_it_says() {
    let archive = library("staticlib", &["--features", "capi"], "release").join("libhug.a");
    for (language, compiler, standard) in [("c", "cc", "-std=c99"), ("cpp", "c++", "-std=c++17")] {
        let source = target().join(format!("ten.{language}"));
        fs::write(&source, block("README.md", language, "int main")).expect("a file");
        let program = source.with_extension(format!("{language}.out"));
        let mut compile = Command::new(compiler);
        compile.args([standard, "-Wall", "-Wextra", "-Werror"]).arg("-o").arg(&program);
        compile.arg(format!("-I{}", root().join("include").display())).arg(&source).arg(&archive);
        run(compile.args(["-lpthread", "-ldl", "-lm"]));
        let printed = run(&mut Command::new(&program));
        assert_eq!(printed, "t 2 u 0.25 v 0.5 prim 0\n", "{language}");
        assert!(read("README.md").contains(&printed), "{language}");
    }
}

/// The one in Rust is the crate's own example, which runs as such.
#[test]
fn the_readme_and_the_crate_begin_alike() {
    let crate_docs = read("src/lib.rs");
    for line in block("README.md", "rust", "Scene::build").lines() {
        assert!(crate_docs.contains(&format!("//! {line}\n")), "src/lib.rs has no {line}");
    }
}

#[test]
fn coming_from_embree_every_call_has_its_line() {
    require_packages();
    let header = ["-E", "-include", "embree3/rtcore.h", "-x", "c", "/dev/null"];
    let header = run(Command::new("cc").args(header));
    let before = header.match_indices('(').filter_map(|(at, _)| {
        header[..at].trim_end().rsplit(|c: char| !c.is_ascii_alphanumeric()).next()
    });
    // Functions of the header itself take packets apart or call the others.
    let inline = |name: &str| {
        let parts = ["ToHitN", "FromHitN", "FromRayN", "FromRayHitN", "Quaternion", "Default"];
        let last = name.bytes().last();
        parts.iter().any(|part| name.contains(part))
            || name.starts_with("rtcInterpolate") && last.is_some_and(|c| c.is_ascii_digit())
    };
    let is_call = |name: &&str| {
        let rest = name.strip_prefix("rtc");
        rest.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_uppercase()))
    };
    let calls: BTreeSet<_> = before.filter(is_call).filter(|name| !inline(name)).collect();
    assert!(calls.len() > 90, "{calls:?}");
    let page = read("docs/from-embree.md");
    let has = |name: &str| ['`', '('].iter().any(|end| page.contains(&format!("`{name}{end}")));
    let left: Vec<_> = calls.into_iter().filter(|name| !has(name)).collect();
    assert!(left.is_empty(), "{left:?}");
}

#[test]
fn every_program_teaches_has_a_line_and_is_run() {
    let readme = fs::read_to_string(root().join("README.md")).expect("README.md");
    let folder = |name: &str| fs::read_dir(root().join(name)).expect(name);
    let paths = |name: &str| folder(name).map(|entry| entry.expect("an entry").path());
    let is_rust = |path: &PathBuf| path.extension().is_some_and(|end| end == "rs");
    let tests: Vec<_> = paths("tests").filter(is_rust).map(fs::read_to_string).collect();
    let mut programs = 0;
    for path in paths("c_examples").filter(|path| path.is_file() && !path.ends_with("Makefile")) {
        let (file, stem) = (path.file_name(), path.file_stem());
        let [file, stem] = [file, stem].map(|name| name.and_then(|n| n.to_str()).expect("a name"));
        let begin = fs::read_to_string(&path).expect("a program");
        let begin = begin.lines().take(6).collect::<Vec<_>>().join("\n");
        assert!(begin.contains("What it teaches"), "{file} does not begin with what it teaches");
        assert!(readme.contains(&format!("| [c_examples/{file}]")), "README.md: no line of {file}");
        let call = format!("\"{stem}\"");
        let run = tests.iter().any(|test| test.as_ref().is_ok_and(|text| text.contains(&call)));
        assert!(run, "{file}: in no test");
        programs += 1;
    }
    assert!(programs > 15, "{programs}");
}
