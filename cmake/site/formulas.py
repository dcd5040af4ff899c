"""A hook of mkdocs: formulas become MathML, which browsers draw without a script."""
import html
import re

from latex2mathml.converter import convert

FORMULA = re.compile(r'<(span|div) class="arithmatex">\\[(\[](.*?)\\[)\]]</\1>', re.DOTALL)


def on_page_content(content, **_):
    def drawn(formula):
        latex = html.unescape(formula[2]).strip()
        # LaTeX parts a function from its neighbours; browsers do not.
        latex = re.sub(r"\\(cos|sin)(?![a-z_^])", r"\\,\\\1\\,", latex)
        return convert(latex, display="block" if formula[1] == "div" else "inline")

    return FORMULA.sub(drawn, content)
