//! Any bytes are a store whose structures can be listed, compared, exported and taken over, or an error.

use dolmen_store::{Act, Place, Search, Store};
use std::time::Duration;

/// The file stands in a folder of its own: the raw files of a store lie beside it.
pub(super) fn run(bytes: &[u8]) {
    let folder = std::env::temp_dir().join(format!("dolmen-store-{}", std::process::id()));
    let _ = std::fs::remove_dir_all(&folder);
    if std::fs::create_dir_all(&folder).is_err() {
        return;
    }
    let place = |name: &str| Place::of(&folder.join(name).display().to_string());
    let opened = match std::fs::write(folder.join("s.db"), bytes) {
        Ok(()) => place("s.db").and_then(|place| Store::open(&place, Duration::ZERO)),
        Err(_) => return,
    };
    if let Ok(mut store) = opened {
        let mut names = Vec::new();
        let _ = store.structures(&Search::default(), &mut |structure| {
            names.push(structure.name.clone());
            Ok(())
        });
        let _ = store.surveys(&Search::default(), &mut |_| Ok(()));
        for name in names.iter().take(3) {
            let _ = (store.structure(name, None), store.export(name));
        }
        let _ = store.verify();
        let own = place("own.db").and_then(|place| Store::open_to_write(&place, Duration::ZERO, 0));
        if let Ok(mut own) = own {
            let act = Act {
                who: "fuzz",
                now_us: 0,
            };
            let _ = own.import(&mut store, &act);
        }
    }
    let _ = std::fs::remove_dir_all(&folder);
}
