"""Markdown pages of a tree: their code, their links, the anchors of their headings."""
import functools
import pathlib
import re

SKIPPED = {"build", "out", "third_party", ".git"}  # folders at the root that are no sources
SPAN = re.compile(r"(`+)(.+?)\1", re.DOTALL)
LINK = re.compile(r"!?\[(?:[^\][]|\[[^\]]*\])*\]\(([^()\s]*(?:\([^()\s]*\))?[^()\s]*)\)")


def pages_of(tree):
    """Every Markdown page, relative to the tree, sorted."""
    found = (path.relative_to(tree) for path in tree.rglob("*.md"))
    return sorted(page for page in found if page.parts[0] not in SKIPPED)


class Page:
    """code: (line number, text) of fenced and indented blocks and of spans; prose: the rest."""

    def __init__(self, path):
        self.path = path
        self.code, prose = [], []
        fence, after_blank, in_list = None, True, False
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            mark = re.match(r"\s*(```+|~~~+)", line)
            if fence or mark:
                if fence and mark and mark[1].startswith(fence):
                    fence = None
                elif not fence:
                    fence = mark[1]
                else:
                    self.code.append((number, line.strip()))
                prose.append("")
                continue
            in_list = bool(re.match(r"\s*([-*]|\d+\.) ", line)) or (in_list and (not line or line[0] == " "))
            # A paragraph of an item is indented, too; its code stands four places further in.
            depth = 7 if in_list else 4
            if line.startswith(" " * depth) and after_blank:
                self.code.append((number, line.strip()))
                prose.append("")
                continue
            after_blank = not line.strip()
            prose.append(line)
        self.prose = "\n".join(prose)
        for span in SPAN.finditer(self.prose):
            self.code.append((self.prose.count("\n", 0, span.start()) + 1, " ".join(span[2].split())))

    def links(self):
        """(line number, target) of links and pictures, those of other sites left out."""
        text = SPAN.sub(lambda span: re.sub(r"[^\n]", "x", span[0]), self.prose)
        text = re.sub(r"\$[^$]*\$", lambda formula: re.sub(r"[^\n]", "x", formula[0]), text)
        for link in LINK.finditer(text):
            if not re.match(r"[a-z]+:", link[1]):
                yield text.count("\n", 0, link.start()) + 1, link[1]

    @functools.cached_property
    def anchors(self):
        """As GitHub names them."""
        found = set()
        for heading in re.findall(r"^#{1,6} +(.*?) *$", self.prose, re.MULTILINE):
            text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
            slug = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
            number, name = 0, slug
            while name in found:
                number, name = number + 1, f"{slug}-{number + 1}"
            found.add(name)
        return found


@functools.lru_cache(maxsize=None)
def page(path):
    return Page(pathlib.Path(path))
