//! A file format: its sections and keys, and what every reader does with a tree of it.

use super::declaration::SectionKeys;
use super::error::CaseError;
use super::key::{Key, Presence};
use super::reader::Reader;
use super::spanned_toml::{Node, Section, Tree, Value, join, nth};

/// The only schema of every format so far.
pub const SCHEMA: u64 = 1;

/// A file format.
#[derive(Debug)]
pub(crate) struct Format {
    /// Name of a file of the format: `case file`.
    pub name: &'static str,
    /// Keys of the head of the file.
    pub head: &'static [Key],
    /// Sections and what each holds, in the order of the template.
    pub sections: &'static [SectionTable],
}

/// One section of a file format.
#[derive(Debug, Clone, Copy)]
pub struct SectionTable {
    /// Name.
    pub name: &'static str,
    /// Content of the section.
    pub meaning: &'static str,
    /// Keys, in the order of the file format.
    pub keys: &'static [Key],
    /// Whether the section may be left out as a whole, and then has no values.
    pub optional: bool,
    /// Whether there may be several of the name.
    pub several: bool,
    /// Heading of the section in the template: in force or not, with a comment.
    pub(crate) heading: Heading,
}

/// Heading of a section in the template.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Heading {
    /// In force.
    Shown(&'static str),
    /// The whole section is commented out.
    Commented(&'static str),
    /// The template does not have it.
    Absent,
}

/// A kind of section: required or with defaults, optional, or several of one name.
pub(crate) trait SectionField: Sized {
    const KEYS: &'static [Key];
    const OPTIONAL: bool = true;
    const SEVERAL: bool = false;

    /// Takes the sections of the name that are there, or a reader that misses every key.
    fn read(sections: &[Reader<'_>], missing: &Reader<'_>) -> Result<Self, CaseError>;
}

impl<D: SectionKeys> SectionField for D {
    const KEYS: &'static [Key] = D::KEYS;
    const OPTIONAL: bool = false;

    fn read(sections: &[Reader<'_>], missing: &Reader<'_>) -> Result<Self, CaseError> {
        D::read(sections.first().unwrap_or(missing))
    }
}

impl<D: SectionKeys> SectionField for Option<D> {
    const KEYS: &'static [Key] = D::KEYS;

    fn read(sections: &[Reader<'_>], _: &Reader<'_>) -> Result<Self, CaseError> {
        sections.first().map(D::read).transpose()
    }
}

impl<D: SectionKeys> SectionField for Vec<D> {
    const KEYS: &'static [Key] = D::KEYS;
    const SEVERAL: bool = true;

    fn read(sections: &[Reader<'_>], _: &Reader<'_>) -> Result<Self, CaseError> {
        sections.iter().map(D::read).collect()
    }
}

/// Declares a file format and the struct of its sections, in the order of the file.
macro_rules! sections {
    ($(#[$doc:meta])* $Name:ident, $FORMAT:ident, $format:literal, $Head:ty {
        $( $section:ident: $Keys:ty, $meaning:literal, $heading:expr; )*
    }) => {
        $(#[$doc])*
        #[derive(Debug)]
        pub(crate) struct $Name {
            /// Head of the file.
            pub head: $Head,
            $( #[doc = $meaning] pub $section: $Keys, )*
        }

        /// The file format.
        pub(crate) static $FORMAT: $crate::case_file::format::Format =
            $crate::case_file::format::Format {
                name: $format,
                head: <$Head as $crate::case_file::declaration::SectionKeys>::KEYS,
                sections: &[ $( $crate::case_file::format::SectionTable {
                    name: stringify!($section),
                    meaning: $meaning,
                    keys: <$Keys as $crate::case_file::format::SectionField>::KEYS,
                    optional: <$Keys as $crate::case_file::format::SectionField>::OPTIONAL,
                    several: <$Keys as $crate::case_file::format::SectionField>::SEVERAL,
                    heading: $heading,
                }, )* ],
            };

        impl $Name {
            /// Reads the sections of a complete tree.
            pub(crate) fn read(
                tree: &$crate::case_file::spanned_toml::Tree,
            ) -> Result<Self, $crate::case_file::error::CaseError> {
                let head = $FORMAT.read_head(tree)?;
                let mut tables = $FORMAT.sections.iter();
                $( let $section = $FORMAT.read_section(tree, tables.next())?; )*
                Ok(Self { head, $( $section, )* })
            }
        }
    };
}
pub(crate) use sections;

impl Format {
    /// Every key with its section, in the order of the file format; the head of the file first.
    pub(crate) fn all(&self) -> impl Iterator<Item = (&'static str, &'static Key)> {
        let of = |(name, keys): (&'static str, &'static [Key])| keys.iter().map(move |k| (name, k));
        let sections = self.sections.iter().map(|s| (s.name, s.keys));
        std::iter::once(("", self.head))
            .chain(sections)
            .flat_map(of)
    }

    /// The keys of a section; none if there is no such section.
    pub(crate) fn of_section(&self, section: &str) -> &'static [Key] {
        if section.is_empty() {
            return self.head;
        }
        let mut sections = self.sections.iter();
        let found = sections.find(|s| s.name == section);
        found.map_or(&[], |s| s.keys)
    }

    /// Looks up a key.
    pub(crate) fn find(&self, section: &str, name: &str) -> Option<&'static Key> {
        self.of_section(section).iter().find(|k| k.name == name)
    }

    /// Whether there is a section of the name.
    pub(crate) fn has_section(&self, name: &str) -> bool {
        self.sections.iter().any(|s| s.name == name)
    }

    /// Suggestion for an unknown name.
    pub(crate) fn hint(&self, section: &str, name: &str) -> String {
        let known = || self.of_section(section).iter().map(|k| k.name);
        let sections = || self.sections.iter().map(|s| s.name);
        if section.is_empty() {
            if let Some(near) = nearest(name, known().chain(sections())) {
                return match self.has_section(near) {
                    true => format!("did you mean [{near}]?"),
                    false => format!("did you mean {near}?"),
                };
            }
        } else if let Some(near) = nearest(name, known()) {
            return format!("did you mean {near}?");
        }
        let named = || self.all().filter(|(_, k)| k.name == name);
        let in_section = named().find(|(section, _)| !section.is_empty());
        if let Some((section, key)) = in_section.or_else(|| named().next()) {
            return format!("did you mean {}?", join(section, key.name));
        }
        if section.is_empty() {
            let near = nearest(name, self.all().map(|(_, k)| k.name));
            if let Some((section, key)) = near.and_then(|n| self.all().find(|(_, k)| k.name == n)) {
                return format!("did you mean {}?", join(section, key.name));
            }
            return format!(
                "its sections are {}",
                sections().collect::<Vec<_>>().join(", ")
            );
        }
        format!("its keys are {}", known().collect::<Vec<_>>().join(", "))
    }

    /// Refuses another schema.
    pub(crate) fn check_schema(&self, tree: &Tree) -> Result<(), CaseError> {
        match tree.find("schema") {
            Some(node) if tree.number("schema") != Some(SCHEMA as f64) => {
                let allowed = format!(
                    "{SCHEMA}, the only schema of {}s that this version of Cageless reads",
                    self.name
                );
                Err(tree.refusal("schema", &node.place.written, &allowed))
            }
            _ => Ok(()),
        }
    }

    /// Refuses another schema, and names that the format does not have; the first in the file if
    /// there are several.
    pub(crate) fn check_names(&self, tree: &Tree) -> Result<(), CaseError> {
        // A later schema may have other keys: say so before complaining about them.
        self.check_schema(tree)?;
        let mut wrong: Vec<CaseError> = Vec::new();
        let mut check = |section: &str, path: &str, entries: &Section| {
            for (key, node) in entries {
                let is_section = section.is_empty() && self.has_section(key);
                if !is_section && self.find(section, key).is_none() {
                    wrong.push(self.unknown(tree, section, path, key, node));
                }
            }
        };
        check("", "", &tree.root);
        for (name, node) in tree.root.iter().filter(|(name, _)| self.has_section(name)) {
            let items = node.items();
            for (k, item) in items.iter().enumerate() {
                if let Value::Section(entries) = &item.value {
                    check(name, &nth(name, k, items.len()), entries);
                }
            }
        }
        let first = wrong
            .into_iter()
            .min_by_key(|e| e.line().unwrap_or(usize::MAX));
        first.map_or(Ok(()), Err)
    }

    fn unknown(
        &self,
        tree: &Tree,
        section: &str,
        path: &str,
        name: &str,
        node: &Node,
    ) -> CaseError {
        let dotted = join(path, name);
        let hint = self.hint(section, name);
        let what = match node.value {
            Value::Section(_) if section.is_empty() => {
                format!("[{name}] is not a section of a {}", self.name)
            }
            _ if section.is_empty() => format!("{dotted} is not a key of a {}", self.name),
            _ => format!("{dotted} is not a key of [{section}]"),
        };
        node.error(&tree.name, &dotted, format!("{what}; {hint}"))
    }

    /// Fills in what keys take that are left out; their dotted names.
    ///
    /// # Errors
    /// Those of [`Tree::sections`].
    pub(crate) fn fill_in(&self, tree: &mut Tree) -> Result<Vec<String>, CaseError> {
        let mut left_out: Vec<(String, &Key)> = vec![];
        let mut absent = |path: &str, keys: &'static [Key], entries: &Section| {
            let keys = keys.iter().filter(|key| !entries.contains_key(key.name));
            left_out.extend(keys.map(|key| (join(path, key.name), key)));
        };
        absent("", self.head, &tree.root);
        for table in self.sections {
            let sections = tree.sections(table)?;
            if sections.is_empty() && !table.optional {
                absent(table.name, table.keys, &Section::new());
            }
            for (path, entries) in sections {
                absent(&path, table.keys, entries);
            }
        }
        let mut defaults = vec![];
        for (path, key) in left_out {
            match (key.presence)() {
                Presence::Default(value) => tree.set(&path, value),
                Presence::Derived => {}
                Presence::Required | Presence::Optional => continue,
            }
            defaults.push(path);
        }
        Ok(defaults)
    }

    /// Reads the head of a complete tree.
    pub(crate) fn read_head<T: SectionKeys>(&self, tree: &Tree) -> Result<T, CaseError> {
        <T as SectionKeys>::read(&Reader {
            tree,
            keys: self.head,
            path: String::new(),
            entries: Some(&tree.root),
        })
    }

    /// Reads the sections of a table.
    pub(crate) fn read_section<T: SectionField>(
        &self,
        tree: &Tree,
        table: Option<&'static SectionTable>,
    ) -> Result<T, CaseError> {
        let table = table.unwrap_or(&self.sections[0]);
        let reader = |path, entries| Reader {
            tree,
            keys: table.keys,
            path,
            entries,
        };
        let sections = tree.sections(table)?.into_iter();
        let sections = sections.map(|(path, entries)| reader(path, Some(entries)));
        let readers: Vec<_> = sections.collect();
        T::read(&readers, &reader(table.name.to_owned(), None))
    }
}

impl Tree {
    /// Number of sections of a name.
    pub(crate) fn count(&self, section: &str) -> usize {
        self.root.get(section).map_or(0, |node| node.items().len())
    }

    /// Dotted paths and contents of the sections of a table.
    ///
    /// # Errors
    /// A [`CaseError`] if one is no section, or there are several where one may be.
    pub(crate) fn sections(
        &self,
        table: &SectionTable,
    ) -> Result<Vec<(String, &Section)>, CaseError> {
        let SectionTable { name, several, .. } = *table;
        let Some(node) = self.root.get(name) else {
            return Ok(vec![]);
        };
        let items = match several {
            true => node.items(),
            false => std::slice::from_ref(node),
        };
        let section = |(k, item): (usize, &'_ Node)| match &item.value {
            Value::Section(_) => Ok(nth(name, k, items.len())),
            Value::List(_) if !several => {
                let message = format!("{name} may be given once only: [{name}]");
                Err(item.error(&self.name, name, message))
            }
            _ => Err(item.refusal(&self.name, name, &format!("a section, [{name}]"))),
        };
        let paths = items.iter().enumerate().map(section);
        let paths = paths.collect::<Result<Vec<_>, _>>()?;
        let contents = items.iter().filter_map(|item| match &item.value {
            Value::Section(entries) => Some(entries),
            _ => None,
        });
        Ok(paths.into_iter().zip(contents).collect())
    }
}

/// The candidate that `given` was most likely meant to be.
pub fn nearest<'a>(given: &str, candidates: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    // A third of the letters wrong is no longer a slip of the pen, nor are two of three.
    let length = given.chars().count();
    let most = match length {
        0..=3 => 1,
        count => (count / 3).max(2),
    };
    // A name may be as long as the file.
    let is_near = |c: &&str| c.chars().count().abs_diff(length) <= most;
    candidates
        .filter(is_near)
        .map(|c| (strsim::damerau_levenshtein(&given.to_lowercase(), c), c))
        .filter(|&(distance, _)| distance <= most)
        .min()
        .map(|(_, candidate)| candidate)
}
