//! Named views of scene files: `scenes.json` in their folder.

use hug_kit::View;
use serde_json::Value;
use std::fs;
use std::path::Path;

/// The views of `scene`, none if the file beside it is missing or says nothing of it.
pub fn beside(scene: &Path) -> Result<Vec<(String, View)>, String> {
    let path = scene.with_file_name("scenes.json");
    let Ok(text) = fs::read_to_string(&path) else { return Ok(Vec::new()) };
    let failed = |what: &dyn std::fmt::Display| format!("{}: {what}", path.display());
    let root: Value = serde_json::from_str(&text).map_err(|error| failed(&error))?;
    let file = scene.file_name().and_then(|name| name.to_str());
    let entry = root.as_array().into_iter().flatten().find(|e| e["file"].as_str() == file);
    let views = entry.and_then(|e| e["views"].as_array()).into_iter().flatten();
    views
        .map(|view| {
            let name = view["name"].as_str().unwrap_or("unnamed");
            let read = view_of(view).ok_or_else(|| {
                failed(&format!("view {name}: needs eye, at, up (3 numbers each) and fov_deg"))
            })?;
            Ok((name.to_owned(), read))
        })
        .collect()
}

fn view_of(view: &Value) -> Option<View> {
    let vector = |key: &str| {
        let numbers: Option<Vec<f32>> =
            view[key].as_array()?.iter().map(|c| c.as_f64().map(|c| c as f32)).collect();
        <[f32; 3]>::try_from(numbers?).ok()
    };
    Some(View {
        eye: vector("eye")?,
        at: vector("at")?,
        up: vector("up")?,
        fov_deg: view["fov_deg"].as_f64()? as f32,
    })
}
