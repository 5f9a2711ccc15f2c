#!/usr/bin/env python3
# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Asks the reference implementation of xacro what generated expressions and templates mean, and writes
its answers into testdata/xacro, where tests replay them.

    tools/xacro_answers.py FOLDER        a folder with the package `xacro` (ros/xacro 2.0.10 or later)

The generators are seeded, so the same reference gives the same files. Errors are kept as such: rigor
must fail, too, with words of its own.
"""
import contextlib
import io
import json
import os
import random
import sys

TESTDATA = os.path.join(os.path.dirname(__file__), '..', 'testdata', 'xacro')
EXPRESSIONS = 400
TEMPLATES = 200
FAILING_TEMPLATES = 40  # most of the templates made are faulty in some line

# What each expression may use. The texts of properties decide their types.
PROPERTIES = {'width': '0.3', 'count': '4', 'name': 'base_link', 'flag': 'true', 'octal': '007',
              'half': '${1/2}', 'sizes': '${[3, 1, 2]}', 'pair': '${(1, 2.5)}',
              'table': "${dict(a=1, b=[2, 3])}", 'empty': '', 'negative': '-7', 'large': '1e300',
              'quoted': "'12'", 'under': '1_000', 'blank': ' 5 '}


class Expressions:
    """A grammar of Python's expressions, weighted to what templates hold."""

    def __init__(self, seed):
        self.random = random.Random(seed)

    def pick(self, *options):
        return self.random.choice(options)

    def number(self):
        r = self.random
        return self.pick(lambda: str(r.randint(0, 20)), lambda: repr(round(r.uniform(0, 10), r.randint(0, 6))),
                         lambda: self.pick('1e-5', '1e16', '1.5e3', '123456789', '0.1', '2.5', '1e22', '5e-324', '.5', '3.',
                                           '0x1f', '1_000', '0b101', '99999999999999999999'),
                         lambda: self.pick('width', 'count', 'half', 'octal', 'negative', 'blank', 'pi'))()

    def arithmetic(self, depth):
        if depth <= 0:
            return self.number()
        a, b = self.arithmetic(depth - 1), self.arithmetic(depth - self.random.randint(1, 2))
        return self.pick(
            lambda: f'{a} {self.pick("+", "-", "*", "/", "//", "%")} {b}',
            lambda: f'({a} {self.pick("+", "-", "*", "/", "//", "%")} {b})',
            lambda: f'-{a}' if not a.startswith('-') else a,
            lambda: f'({a}) ** {self.pick("2", "0.5", "-1", "3")}',
            lambda: f'{self.pick("sin", "cos", "radians", "degrees", "floor", "ceil", "fabs", "atan")}({a})',
            lambda: f'{self.pick("round", "int", "float", "python.abs")}({a})',
            lambda: f'round({a}, {self.random.randint(-2, 5)})',
            lambda: f'{self.pick("min", "max")}({a}, {b})',
            lambda: f'math.{self.pick("trunc", "sqrt", "exp", "tanh", "log1p")}({a})',
            lambda: f'({a} if {self.condition(depth - 1)} else {b})',
            lambda: f'{self.pick("hypot", "atan2", "fmod", "copysign", "pow")}({a}, {b})',
            lambda: f'len({self.text(depth - 1)})',
            lambda: f'{self.items(depth - 1)}[{self.pick("0", "-1", "1")}]',
            lambda: f'python.sum({self.items(depth - 1)})',
            lambda: f'{self.pick("count", "octal", "negative", "7", "12")} {self.pick("<<", ">>", "&", "|", "^")} {self.pick("1", "2", "3")}')()

    def condition(self, depth):
        a, b = self.arithmetic(depth - 1), self.arithmetic(depth - 1)
        return self.pick(
            lambda: f'{a} {self.pick("<", "<=", ">", ">=", "==", "!=")} {b}',
            lambda: f'{a} < {b} <= {self.number()}',
            lambda: f'not {a}',
            lambda: f'({a}) {self.pick("and", "or")} ({b})',
            lambda: f'{self.text(0)} {self.pick("in", "not in")} {self.text(0)}',
            lambda: f'{self.text(0)} {self.pick("==", "!=", "<")} {self.text(0)}',
            lambda: f'{self.number()} in {self.items(0)}',
            lambda: f'{self.pick("None", "flag", "empty")} is {self.pick("None", "not None", "True")}',
            lambda: f'python.{self.pick("any", "all")}({self.items(0)})',
            lambda: f'python.isinstance({self.pick("width", "count", "name", "sizes", "flag")}, python.{self.pick("int", "float", "str", "list")})')()

    def text(self, depth):
        literal = self.pick("'arm'", '"left_arm"', "'a,b,,c'", "' x '", 'name', "'Ab1'", "'é1'", "''", 'quoted', 'under')
        if depth <= 0:
            return literal
        a = self.text(depth - 1)
        return self.pick(
            lambda: f'{a} + {self.text(depth - 1)}',
            lambda: f'str({self.arithmetic(depth - 1)})',
            lambda: f"{literal}.{self.pick('strip()', 'replace(%s, %s)' % (repr('a'), repr('_')), 'zfill(6)', 'center(9, %s)' % repr('*'), 'ljust(7)', 'title()' if literal != repr('é1') else 'strip()')}",
            lambda: f"{literal}[{self.pick('0:2', '::-1', '1:', ':-1', '-2:')}]",
            lambda: f"'{self.pick('%d', '%5.2f', '%s', '%03d', '%g', '%e', '%+.1f', '%x')}' % {self.pick('count', '12', 'octal')}",
            lambda: f"'_'.join({literal}.split({self.pick('', repr(','), repr('_'), repr('_') + ', 1')}))",
            lambda: f"{literal} * {self.pick('2', '0', '3')}",
            lambda: f"{self.pick('list', 'python.tuple', 'python.sorted')}({literal})",
            lambda: f"{literal}.{self.pick('find', 'count', 'startswith', 'endswith', 'partition')}({repr(self.pick('a', '_', 'm', 'rm'))})",
            lambda: f'{literal}.{self.pick("upper", "lower", "isdigit", "capitalize", "swapcase", "islower")}()' if literal != "'é1'" else f'len({literal})')()

    def items(self, depth):
        a, b = self.number(), self.number()
        return self.pick(
            lambda: f'[{a}, {b}]', lambda: 'sizes', lambda: 'pair', lambda: f'({a}, {b}, {self.number()})',
            lambda: f'[x * 2 for x in sizes]', lambda: f'[x for x in python.range({self.pick("3", "5")}) if x % 2 == {self.pick("0", "1")}]',
            lambda: f'list(python.range({self.random.randint(1, 4)}, {self.random.randint(5, 9)}, {self.pick("1", "2")}))',
            lambda: f'python.sorted(sizes, reverse={self.pick("True", "False")})', lambda: f"table['b']",
            lambda: f'[i + j for i, j in python.zip(sizes, pair)]', lambda: f'list(map(float, sizes))',
            lambda: f'sizes + [{a}]', lambda: f'[a for a, b in python.enumerate(sizes)]')()

    def one(self):
        depth = self.random.randint(1, 3)
        return self.pick(lambda: self.arithmetic(depth), lambda: self.arithmetic(depth), lambda: self.condition(depth),
                         lambda: self.text(depth), lambda: self.items(depth), lambda: self.fixed())()

    def fixed(self):
        return self.pick(
            "table", "table['a'] / 3", "dict(a=1, b=2).items()", "list(dict(z=1, y=2).keys())", "table.get('q', 5)", "table['q']",
            "name.missing", "undefined", "1 +", "(1, 2", "2 ** 70", "2 ** 0.5", "-2 ** 2", "2 ** -1", "7 // -2", "-7 % 3", "7.5 // 2",
            "-7.5 % 2", "1 / 0", "0.1 + 0.2", "1e400", "-1e400", "round(2.5)", "round(-0.5)", "round(0.15, 1)", "round(12345, -2)",
            "True + True", "1 == 1.0 == True", "float('nan')", "int('0x1f', 16)", "int(' 12 ')", "int('1_0')", "float('1_0.5')",
            "str(None)", "None", "(1,)", "()", "[]", "[[], ()]", "'it\\'s'", "['a\\n', \"it's\"]", "factorial(25)", "gcd(12, 18)",
            "math.comb(50, 25)", "log(8, 2)", "log10(1000)", "log(0)", "sqrt(-1)", "acos(2)", "exp(1000)", "math.inf - math.inf",
            "1e16", "123456789012345680.0", "1e15", "0.0001", "0.00001", "1 if empty else 2", "not not sizes", "1 < 2 < 3 > 2",
            "sizes[5]", "sizes[-3]", "sizes[0:2] * 2", "'abc'[::2]", "len(table)", "xacro.tokenize('a,b; c')", "python.divmod(-7, 2)",
            "[x for row in [[1, 2], [3]] for x in row]", "[(a, b) for a in 'ab' for b in (1, 2) if b > 1]", "max(sizes, key=str)",
            "min([])", "python.sum(x for x in sizes)", "'%s-%s' % (1, 'b')", "'%5.1f|' % 3.14159", "'{:>6.2f}'", "name.split('_')[1]",
            "lambda", "__import__", "name.__class__", "5 .real", "isinf(inf)", "modf(2.5)", "frexp(8)", "fsum([0.1] * 10)",
            "python.list(python.reversed(sizes))", "python.set([1, 1, 2])", "len(python.set(name))", "1 in python.set(sizes)",
            "'a' < 'b' < 'c'", "'a' < 1", "[1, 2] < [1, 3]", "~5", "5 & 3 | 8", "1 << 65", "'x' * -1", "sizes is sizes", "count is 4 or 5",
            "octal + 1", "quoted + 1", "under", "blank * 2", "radians(180)", "degrees(pi)", "hypot(3, 4)", "tau", "e", "isclose(1, 1 + 1e-10)",
            "python.sorted(table)", "python.list(table.values())", "'b' in table", "python.repr('a')", "python.type(1)", "python.ord('a')",
            "ldexp(1.5, 3)", "copysign(1, -0.0)", "-0.0", "0.0 == -0.0", "1 // 1.0", "5 % -3", "-5 % 3.0", "1e308 * 10", "10 ** 20", "10 ** -5",
            "1e5", "100000000000000000000.0", "float(10 ** 20)", "10 ** 400 / 10 ** 399", "2 ** 1024 * 1.0", "int(1e20)", "int('abc')")


MACROS = ['<xacro:macro name="leg" params="prefix mass:={m} *origin"><link name="${{prefix}}_leg" mass="${{mass * 2}}">'
          '<xacro:insert_block name="origin"/></link></xacro:macro>',
          '<xacro:macro name="box" params="size:=^|1 name:=\'a b\'"><box size="${{size}}">${{name}}</box></xacro:macro>',
          '<xacro:macro name="many" params="n"><xacro:if value="${{n > 0}}"><item i="${{n}}"/><!-- of {m} -->'
          '<xacro:many n="${{n - 1}}"/></xacro:if></xacro:macro>',
          '<xacro:macro name="wrap" params="**content"><wrapped><xacro:insert_block name="content"/></wrapped></xacro:macro>']
CALLS = ['<xacro:leg prefix="{w}"><origin xyz="{n} 0 ${{{n} / 2}}"/></xacro:leg>',
         '<xacro:leg prefix="{w}" mass="{n}">\n  <origin/>\n</xacro:leg>', '<xacro:leg prefix="{w}"/>',
         '<xacro:box/>', '<xacro:box size="{n}" name="{w}"/>', '<xacro:box wrong="1"/>', '<xacro:many n="{d}"/>',
         '<xacro:wrap><content><a/><!-- kept --><b c="${{{n}}}"/>text</content></xacro:wrap>',
         '<xacro:call macro="${{\'bo\' + \'x\'}}" size="{n}"/>', '<xacro:nothing/>']
PIECES = ['<xacro:property name="size" value="{n}"/>', '<xacro:property name="size" value="${{{n} * 2}}"/>',
          '<xacro:property name="late" value="${{size + 1}}"/>', '<link a="${{late}}"/>', '<link b="${{size}}">${{size}} m</link>',
          '<!-- before a tag -->\n<xacro:property name="kept" value="{w}"/>', '<!-- a comment ${{size}} -->',
          '<xacro:if value="{c}"><yes/><!-- last --></xacro:if>', '<xacro:unless value="{c}">\n  <no/>\n</xacro:unless>',
          '<xacro:if value="${{size > {n}}}">  <!-- first -->\n<big/>\n</xacro:if>', '<a>$${{size}} costs $5 &lt; &quot;6&quot;</a>',
          '<xacro:arg name="side" default="{w}"/>', '<link s="$(arg side)"/>', '<xacro:arg name="length" default="${{{n}}}"/>',
          '<link l="${{2 * $(arg length)}}"/>', '<e>$(eval length * 2)</e>', '<env>$(optenv RIGOR_NOT_SET some words)</env>',
          '<xacro:property name="block"><one/><two v="${{size}}"/></xacro:property>', '<xacro:insert_block name="block"/>',
          '<xacro:element xacro:name="made_{w}" k="v"/>', '<el><xacro:attribute name="at" value="${{\'{w}\'}}"/></el>',
          '<xacro:property name="size" remove="true"/>', '<xacro:property name="size" default="{n}"/>',
          '<xacro:property name="eager" value="${{size}}" lazy_eval="false"/>', '<link e="${{eager}}"/>',
          '<![CDATA[ raw ${{size}} ]]>', '<t>one<u/>two ${{size}}</t>', '<?target data?>', '<v>\n\n</v>', '<v></v>',
          '<!-- xacro:eval-comments --><!-- now ${{size}} -->', '<w zeta="1" alpha="{w}"/>', '<x y="${{[size, {n}]}}"/>',
          '<xacro:property name="cycle" value="${{cycle}}"/>', '<y>${{xacro.load_yaml(\'config.yaml\')[\'arm\'][\'mass\'] * {n}}}</y>',
          '<y>${{xacro.load_yaml(\'config.yaml\').arm.links[{d}]}}</y>', '<xacro:include filename="part.xacro"/>',
          '<xacro:include filename="missing.xacro" optional="true"/>', '<xacro:include filename="p*.xacro"/>',
          '<xacro:include filename="part.xacro" ns="ns"/><l q="${{ns.from_part}}"/>', '<p>${{from_part}}</p>',
          '<xacro:macro name="sets"><xacro:property name="out" value="${{size}}" scope="parent"/></xacro:macro><xacro:sets/><o>${{out}}</o>',
          '<xacro:macro name="shouts"><xacro:property name="loud" value="{w}" scope="global"/></xacro:macro><xacro:shouts/><o>${{loud}}</o>']
FILES = {'part.xacro': '<part xmlns:xacro="http://www.ros.org/wiki/xacro" xmlns:extra="http://extra">\n  <!-- of the part -->\n'
                       '  <xacro:property name="from_part" value="12"/>\n  <piece size="${from_part}"/>\n</part>\n',
         'config.yaml': 'arm:\n  mass: 1.5\n  links: [base, 2, 0x10, yes, "3", 1e3, 1.0e+3, !degrees 180, ~]\n'}


def template(rng):
    def fill(piece):
        return piece.format(n=rng.choice(['1', '0.5', '2', '3.25', '1e-3']), w=rng.choice(['left', 'a', 'x_1', '007']),
                            c=rng.choice(['true', '0', '1', 'False', '${size == 1}', 'maybe', '${1 &lt; 2}']),
                            d=rng.choice(['0', '1', '3', '7']), m=rng.choice(['1', '0.25']))
    lines = [fill('<xacro:property name="size" value="{n}"/>')]
    lines += [fill(m) for m in MACROS if rng.random() < 0.8]
    for _ in range(rng.randint(2, 7)):
        lines.append(fill(rng.choice(rng.choice([PIECES, PIECES, CALLS]))))
    gap = rng.choice(['\n  ', '\n  ', '\n\n  ', ''])
    return '<?xml version="1.0"?>\n<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">' + gap + gap.join(lines) + '\n</robot>\n'


def written(name, rows):
    with open(os.path.join(TESTDATA, name), 'w', encoding='utf-8') as out:
        for row in rows:
            out.write(json.dumps(row, ensure_ascii=False) + '\n')


def quietly(function):
    """The function's result, or None where it fails."""
    try:
        with contextlib.redirect_stderr(io.StringIO()), contextlib.redirect_stdout(io.StringIO()):
            return function()
    except (Exception, SystemExit, RecursionError):
        return None


def main():
    sys.path.insert(0, sys.argv[1])
    import xacro

    def evaluate(expression):
        xacro.init_stacks('test.xacro')
        table = xacro.Table(xacro._global_symbols)
        for name, value in PROPERTIES.items():
            table[name] = value
        return str(xacro.eval_text('${' + expression + '}', table))

    def expand(text):
        with open('test.xacro', 'w', encoding='utf-8') as out:
            out.write(text)
        return xacro.process_file('test.xacro').toprettyxml(indent='  ')

    os.makedirs(TESTDATA, exist_ok=True)
    generator = Expressions(2026)
    rows, seen = [], set()
    while len(rows) < EXPRESSIONS:
        expression = generator.one()
        if expression in seen or '}' in expression:
            continue
        seen.add(expression)
        value = quietly(lambda: evaluate(expression))
        # Addresses, and the order of sets of texts, differ from run to run; complex numbers are no part.
        if value is not None and (' at 0x' in value or 'j' in value and '(' in value):
            continue
        rows.append({'expression': expression, 'value': value})
    written('expressions.jsonl', [{'properties': PROPERTIES}] + rows)

    import tempfile
    folder = tempfile.mkdtemp()
    target = os.path.abspath(TESTDATA)
    globals()['TESTDATA'] = target
    os.chdir(folder)
    for name, text in FILES.items():
        with open(name, 'w', encoding='utf-8') as out:
            out.write(text)
    rng = random.Random(2026)
    templates, failing = [], 0
    while len(templates) < TEMPLATES:
        text = template(rng)
        result = quietly(lambda: expand(text))
        failing += result is None
        if result is not None or failing <= FAILING_TEMPLATES:
            templates.append({'template': text, 'text': result})
    written('templates.jsonl', [{'files': FILES}] + templates)
    for rows_, key in ((rows, 'value'), (templates, 'text')):
        print(len(rows_), 'of them fail:', sum(r[key] is None for r in rows_))


if __name__ == '__main__':
    main()
