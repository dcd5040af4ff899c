"""Links lead to files and headings that are there; API sheets name what their headers declare."""
import os
import re

from pages import page, pages_of


def broken_links(tree):
    for name in pages_of(tree):
        for line, target in page(tree / name).links():
            path, _, anchor = target.partition("#")
            file = tree / os.path.normpath(name.parent / path) if path else tree / name
            if not file.exists() or file.relative_to(tree).parts[0] == "..":
                yield f"{name}:{line}: {target} is not there"
            elif anchor and file.suffix == ".md" and anchor not in page(file).anchors:
                yield f"{name}:{line}: {target}: the page has no such heading"


def unknown_names(tree):
    """Rows | `names` | `file` | ... of labs/*/api.md whose file does not have the name."""
    for sheet in sorted(tree.glob("labs/*/api.md")):
        rows = 0
        for number, line in enumerate(sheet.read_text(encoding="utf-8").splitlines(), 1):
            row = re.match(r"\| (`.*?`) \| `([^`]+)` \|", line)
            if not row:
                continue
            rows += 1
            place = f"{sheet.relative_to(tree)}:{number}"
            file = tree / row[2]
            if not file.is_file():
                yield f"{place}: {row[2]} is not there"
                continue
            text = re.sub(r"//.*", "", file.read_text(encoding="utf-8"))
            for name in re.findall(r"`(\w+)`", row[1]):
                if not re.search(rf"\b{name}\b", text):
                    yield f"{place}: {row[2]} has no {name}"
        if rows == 0:
            yield f"{sheet.relative_to(tree)}: no rows were found"
