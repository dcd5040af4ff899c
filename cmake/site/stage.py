"""Lays the tree's pages out for mkdocs.

    stage.py TREE PAGES [--with-answers]

PAGES/docs gets every Markdown page at its place in the tree, with the files that it links to; PAGES/mkdocs.yml the
navigation. The pages themselves are written for GitHub's Markdown; what Python's reads otherwise is changed here.
"""
import os
import pathlib
import re
import shutil
import sys

import yaml

HERE = pathlib.Path(__file__).resolve().parent
SKIPPED = {"build", "out", "third_party", ".git"}
ANSWERS = "docs/instructor/answers"
LINK = re.compile(r"(!?)\[((?:[^\][]|\[[^\]]*\])*)\]\(([^()\s]+)\)")

# Patterns in the order of the navigation; a page belongs to the first section that has it.
SECTIONS = {
    "Students": ["docs/guide/README.md", "docs/guide/setup.md", "docs/guide/student.md", "common/simt/debugging.md",
                 "docs/guide/performance.md", "docs/guide/writeup.md", "docs/guide/glossary.md", "docs/guide/*.md"],
    "Labs": ["labs/*/README.md", "labs/*/api.md", "docs/lecture.md"],
    "Instructors": ["docs/instructor/README.md", "docs/instructor/semester.md", "docs/instructor/scripts.md",
                    "docs/instructor/running.md", "docs/instructor/*.md", ANSWERS + "/*.md"],
    "Graders": ["docs/grading*.md", "docs/judging*.md"],
    "Reference": ["scenes/README.md", "docs/formats.md", "docs/machine.md", "common/simt/README.md", "docs/vendor.md",
                  "docs/architecture.md", "CONTRIBUTING.md", "**/*.md"],
}


def for_pythons_markdown(text):
    """Lists may follow a paragraph at once; what belongs to an item is indented by four; <details> holds Markdown."""
    lines, in_list, loose, fenced = [], False, False, False
    for line in text.splitlines():
        if line.startswith("```"):
            fenced = not fenced
        if not fenced:
            item = re.match(r"([-*]|\d+\.) ", line)
            # loose: an item has several paragraphs, so an item behind the last of them begins after a blank line.
            if item and (loose or not in_list) and lines and lines[-1].strip():
                lines.append("")
            indent = len(line) - len(line.lstrip())
            in_list = bool(item) or (in_list and (not line or indent > 0))
            loose = in_list and not item and (loose or not line)
            if in_list and not item and 0 < indent < 4:
                line = "    " + line.lstrip()
        lines.append(line)
    return "\n".join(lines).replace("<details>", "<details markdown>") + "\n"


def title_of(page):
    heading = re.search(r"^# +(.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return heading[1].replace("`", "") if heading else page.stem


def navigation(docs):
    left = {str(page.relative_to(docs)) for page in docs.rglob("*.md")} - {"README.md"}
    nav = [{"Home": "README.md"}]
    for section, patterns in SECTIONS.items():
        entries = []
        for pattern in patterns:
            for page in sorted(docs.glob(pattern)):
                name = str(page.relative_to(docs))
                if name in left:
                    left.remove(name)
                    entries.append({title_of(page): name})
        if entries:
            nav.append({section: entries})
    return nav


def main():
    tree, pages = (pathlib.Path(name).resolve() for name in sys.argv[1:3])
    with_answers = "--with-answers" in sys.argv[3:]
    docs = pages / "docs"
    shutil.rmtree(pages, ignore_errors=True)
    docs.mkdir(parents=True)

    def is_staged(name):
        return with_answers or not name.startswith(ANSWERS)

    def staged_link(folder, link):
        """The link as the site has it; copies a file that is no page."""
        picture, text, target = link.groups()
        path, hash_mark, anchor = target.partition("#")
        if re.match(r"[a-z]+:", target) or not path:
            return link[0]
        name = os.path.normpath(os.path.join(folder, path))
        if not is_staged(name):
            return text
        if (tree / name).is_dir() and (tree / name / "README.md").is_file():
            name, path = name + "/README.md", path.rstrip("/") + "/README.md"
        elif (tree / name).is_file() and not name.endswith(".md"):
            (docs / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(tree / name, docs / name)
        return f"{picture}[{text}]({path}{hash_mark}{anchor})"

    for page in sorted(tree.rglob("*.md")):
        name = str(page.relative_to(tree))
        if page.relative_to(tree).parts[0] in SKIPPED or not is_staged(name):
            continue
        text = LINK.sub(lambda link: staged_link(os.path.dirname(name), link), page.read_text(encoding="utf-8"))
        (docs / name).parent.mkdir(parents=True, exist_ok=True)
        (docs / name).write_text(for_pythons_markdown(text), encoding="utf-8")

    for asset in ("iframe-worker.js", "site.css"):
        shutil.copyfile(HERE / asset, docs / asset)
    rest = {"hooks": [str(HERE / "formulas.py")], "nav": navigation(docs)}
    settings = (HERE / "mkdocs.yml").read_text() + yaml.safe_dump(rest, allow_unicode=True, sort_keys=False)
    (pages / "mkdocs.yml").write_text(settings, encoding="utf-8")


if __name__ == "__main__":
    main()
