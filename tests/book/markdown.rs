//! As much Markdown as the checks need: fenced blocks, and the prose between them.

/// A fenced block of code.
pub struct Fence<'a> {
    /// Line of the opening fence, from 1.
    pub line: usize,
    /// The words after the fence: `console,checkpoint` gives `console` and `checkpoint`.
    pub info: Vec<&'a str>,
    /// What stands between the fences.
    pub lines: Vec<&'a str>,
    /// Whether the closing fence was found.
    pub closed: bool,
}

impl Fence<'_> {
    /// The language: the first word after the fence, or nothing.
    pub fn language(&self) -> &str {
        self.info.first().copied().unwrap_or_default()
    }
}

/// The mark that opens a fence in this line, if any: three or more backticks or tildes.
fn mark(line: &str) -> Option<&str> {
    let line = line.trim_start();
    let first = line.chars().next().filter(|c| matches!(c, '`' | '~'))?;
    let length = line.chars().take_while(|c| *c == first).count();
    (length >= 3).then(|| &line[..length])
}

/// The fenced blocks of a page, and its other lines with their numbers, inline code taken out.
pub fn split(text: &str) -> (Vec<Fence<'_>>, Vec<(usize, String)>) {
    let mut fences: Vec<Fence> = Vec::new();
    let mut prose = Vec::new();
    let mut open: Option<&str> = None;
    for (i, line) in text.lines().enumerate() {
        match (open, mark(line)) {
            (None, Some(fence)) => {
                let info = line.trim_start()[fence.len()..].split([',', ' ']);
                fences.push(Fence {
                    line: i + 1,
                    info: info.filter(|word| !word.is_empty()).collect(),
                    lines: Vec::new(),
                    closed: false,
                });
                open = Some(fence);
            }
            (None, None) => prose.push((i + 1, without_code(line))),
            (Some(opening), _) => {
                let fence = fences.last_mut().expect("a fence is open");
                let trimmed = line.trim();
                if trimmed.len() >= opening.len() && trimmed.trim_start_matches(opening).is_empty()
                {
                    fence.closed = true;
                    open = None;
                } else {
                    fence.lines.push(line);
                }
            }
        }
    }
    (fences, prose)
}

/// The line without what stands between backticks.
fn without_code(line: &str) -> String {
    line.split('`').step_by(2).collect::<Vec<_>>().join(" ")
}

/// The formulas of a page, piece by piece, each with its line: what stands between dollars.
pub fn formulas(text: &str) -> Vec<(usize, String)> {
    let (_, prose) = split(text);
    let mut found = Vec::new();
    let mut inside = false;
    for (number, line) in prose {
        let line = line.replace("\\$", "").replace("$$", "$");
        for (i, piece) in line.split('$').enumerate() {
            inside ^= i > 0;
            if inside && !piece.trim().is_empty() {
                found.push((number, piece.to_owned()));
            }
        }
    }
    found
}
