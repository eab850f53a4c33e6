//! The LaTeX-math reader, seen from outside: the report's equations, the refusals, and the law of the printer.

use std::sync::Arc;

use cradle_verify::algebra::{BigRational, Expr, Function, LimitPoint, Symbol};
use cradle_verify::document::Span;
use cradle_verify::notation::{
    Clause, Precision, SyntaxError, latex, latex_statement, plain, read_display, read_expr,
    read_formulas, read_symbol,
};

use crate::common::last;
use proptest::prelude::*;

fn whole(text: &str) -> Span {
    Span::new(0, text.len())
}

fn printed(source: &str) -> Result<String, SyntaxError> {
    let statements = read_display(source, whole(source)).statements?;
    Ok(statements
        .iter()
        .map(latex_statement)
        .collect::<Vec<_>>()
        .join(" ;; "))
}

/// The equations as the report's author wrote them, and as they are read; `;;` separates statements.
const REPORT: &[(&str, &str)] = &[
    (
        r"mv_0 = mv_1 + mv_2 + mv_3 + mv_4 + mv_5 \quad (1)",
        r"m v_0 = m v_1 + m v_2 + m v_3 + m v_4 + m v_5",
    ),
    (
        r"v_0 = v_1 + v_2 + v_3 + v_4 + v_5 \quad (2)",
        r"v_0 = v_1 + v_2 + v_3 + v_4 + v_5",
    ),
    (
        r"\frac{1}{2}mv_0^2 = \frac{1}{2}mv_1^2 + \frac{1}{2}mv_2^2 + \frac{1}{2}mv_3^2 + \frac{1}{2}mv_4^2 + \frac{1}{2}mv_5^2 \quad (3)",
        r"\frac{1}{2} m v_0^2 = \frac{1}{2} m v_1^2 + \frac{1}{2} m v_2^2 + \frac{1}{2} m v_3^2 + \frac{1}{2} m v_4^2 + \frac{1}{2} m v_5^2",
    ),
    (
        r"v_0^2 = v_1^2 + v_2^2 + v_3^2 + v_4^2 + v_5^2 \quad (4)",
        r"v_0^2 = v_1^2 + v_2^2 + v_3^2 + v_4^2 + v_5^2",
    ),
    (
        r"v_0 \stackrel{?}{=} 0 + 0 + 0 + \frac{v_0}{2} + \frac{v_0}{2} = v_0 \quad \checkmark \quad (5)",
        r"v_0 \stackrel{?}{=} 0 + 0 + 0 + \frac{v_0}{2} + \frac{v_0}{2} = v_0 \quad \checkmark",
    ),
    (
        r"v_0^2 \stackrel{?}{=} 0 + 0 + 0 + \left(\frac{v_0}{2}\right)^2 + \left(\frac{v_0}{2}\right)^2 = \frac{v_0^2}{4} + \frac{v_0^2}{4} = \frac{v_0^2}{2} \quad \times \quad (6)",
        r"v_0^2 \stackrel{?}{=} 0 + 0 + 0 + \left( \frac{v_0}{2} \right)^2 + \left( \frac{v_0}{2} \right)^2 = \frac{v_0^2}{4} + \frac{v_0^2}{4} = \frac{v_0^2}{2} \quad \times",
    ),
    (
        r"v_0 \stackrel{?}{=} 0 + 0 + 0 + 0 + v_0 = v_0 \quad \checkmark \quad (7)",
        r"v_0 \stackrel{?}{=} 0 + 0 + 0 + 0 + v_0 = v_0 \quad \checkmark",
    ),
    (
        r"v_0^2 \stackrel{?}{=} 0 + 0 + 0 + 0 + v_0^2 = v_0^2 \quad \checkmark \quad (8)",
        r"v_0^2 \stackrel{?}{=} 0 + 0 + 0 + 0 + v_0^2 = v_0^2 \quad \checkmark",
    ),
    (
        r"2v_0 \stackrel{?}{=} 0 + 0 + 0 + 0 + 2v_0 = 2v_0 \quad \checkmark \quad (9)",
        r"2 v_0 \stackrel{?}{=} 0 + 0 + 0 + 0 + 2 v_0 = 2 v_0 \quad \checkmark",
    ),
    (
        r"\text{Initial: } v_0^2 + v_0^2 = 2v_0^2 \quad (10)",
        r"\text{Initial: } v_0^2 + v_0^2 = 2 v_0^2",
    ),
    (
        r"\text{Final: } 0 + 0 + 0 + 0 + (2v_0)^2 = 4v_0^2 \quad (11)",
        r"\text{Final: } 0 + 0 + 0 + 0 + (2 v_0)^2 = 4 v_0^2",
    ),
    (
        r"2v_0^2 \neq 4v_0^2 \quad \times \quad (12)",
        r"2 v_0^2 \neq 4 v_0^2 \quad \times",
    ),
    (
        r"2v_0 \stackrel{?}{=} 0 + 0 + 0 + v_0 + v_0 = 2v_0 \quad \checkmark \quad (13)",
        r"2 v_0 \stackrel{?}{=} 0 + 0 + 0 + v_0 + v_0 = 2 v_0 \quad \checkmark",
    ),
    (
        r"\text{Initial: } v_0^2 + v_0^2 = 2v_0^2 \quad (14)",
        r"\text{Initial: } v_0^2 + v_0^2 = 2 v_0^2",
    ),
    (
        r"\text{Final: } 0 + 0 + 0 + v_0^2 + v_0^2 = 2v_0^2 \quad (15)",
        r"\text{Final: } 0 + 0 + 0 + v_0^2 + v_0^2 = 2 v_0^2",
    ),
    (
        r"2v_0^2 = 2v_0^2 \quad \checkmark \quad (16)",
        r"2 v_0^2 = 2 v_0^2 \quad \checkmark",
    ),
    (
        r"nv_0 = u_1 + u_2 + \cdots + u_k = \sum_{i=1}^k u_i \quad (17)",
        r"n v_0 = \sum_{i = 1}^{k} u_i = \sum_{i = 1}^{k} u_i",
    ),
    (
        r"nv_0^2 = u_1^2 + u_2^2 + \cdots + u_k^2 = \sum_{i=1}^k u_i^2 \quad (18)",
        r"n v_0^2 = \sum_{i = 1}^{k} u_i^2 = \sum_{i = 1}^{k} u_i^2",
    ),
    (
        r"\left(\sum_{i=1}^k u_i \right)^2 \leq k \sum_{i=1}^k u_i^2 \quad (19)",
        r"\left( \sum_{i = 1}^{k} u_i \right)^2 \leq k \sum_{i = 1}^{k} u_i^2",
    ),
    (
        r"(nv_0)^2 \leq k(nv_0^2) \quad (20)",
        r"(n v_0)^2 \leq k (n v_0^2)",
    ),
    (
        r"n^2 v_0^2 \leq knv_0^2 \quad (21)",
        r"n^2 v_0^2 \leq k n v_0^2",
    ),
    (r"n \leq k \quad (22)", r"n \leq k"),
    (r"k \leq n \quad (23)", r"k \leq n"),
    (r"\boxed{k = n} \quad (24)", r"k = n"),
    (r"u_1 = u_2 = \dots = u_n \quad (25)", r"u_1 = \dots = u_n"),
    (
        r"nv_0 = nu \Rightarrow u = v_0 \quad (26)",
        r"n v_0 = n u \Rightarrow u = v_0",
    ),
    (
        r"\Delta E_{\text{total}} = (1 - e^2)E_0 \quad (27)",
        r"\Delta E_{\text{total}} = (1 - e^2) E_0",
    ),
    (
        r"E_0 = \frac{1}{2}mv_0^2. \quad (28)",
        r"E_0 = \frac{1}{2} m v_0^2",
    ),
    (
        r"F(\delta) = k\delta^{3/2} \quad (29)",
        r"F(\delta) = k \delta^{3/2}",
    ),
    (
        r"k = \frac{4}{3} E^* \sqrt{R^*}. \quad (30)",
        r"k = \frac{4}{3} E^* \sqrt{R^*}",
    ),
    (
        r"\frac{1}{E^*} = \frac{1 - \nu_1^2}{E_1} + \frac{1 - \nu_2^2}{E_2}, \quad (31)",
        r"\frac{1}{E^*} = \frac{1 - \nu_1^2}{E_1} + \frac{1 - \nu_2^2}{E_2}",
    ),
    (
        r"\frac{1}{R^*} = \frac{1}{R_1} + \frac{1}{R_2}. \quad (32)",
        r"\frac{1}{R^*} = \frac{1}{R_1} + \frac{1}{R_2}",
    ),
    (
        r"E^* = \frac{E}{1 - \nu^2}, \quad R^* = \frac{R}{2}. \quad (33)",
        r"E^* = \frac{E}{1 - \nu^2} ;; R^* = \frac{R}{2}",
    ),
    (
        r"F(\delta, \dot{\delta}) = k\delta^{3/2} + \gamma\delta^{1/2}\dot{\delta} \quad (34)",
        r"F(\delta, \dot{\delta}) = k \delta^{3/2} + \gamma \delta^{1/2} \dot{\delta}",
    ),
    (
        r"E_{\text{heat}} = \int_0^\tau \gamma\delta^{1/2}\dot{\delta}^2 dt. \quad (35)",
        r"E_{\text{heat}} = \int_{0}^{\tau} \gamma \delta^{1/2} \dot{\delta}^2 \, dt",
    ),
    (
        r"E_{\text{heat}} \sim \gamma m^{1/2} k^{-3/2} v_0^{6/5}. \quad (36)",
        r"E_{\text{heat}} \sim \gamma m^{1/2} k^{-3/2} v_0^{6/5}",
    ),
    (
        r"P \sim \frac{\rho_{\text{air}}}{c_{\text{air}}} A^2 a^2 \quad (37)",
        r"P \sim \frac{\rho_{\text{air}}}{c_{\text{air}}} A^2 a^2",
    ),
    (
        r"E_{\text{sound}} = \int_0^\tau P(t) dt. \quad (38)",
        r"E_{\text{sound}} = \int_{0}^{\tau} P(t) \, dt",
    ),
    (
        r"E_{\text{sound}} \sim \frac{\rho_{\text{air}}}{c_{\text{air}}} R^{21/5} (E^*)^{2/5} m^{-2/5} v_0^{7/5}. \quad (39)",
        r"E_{\text{sound}} \sim \frac{\rho_{\text{air}}}{c_{\text{air}}} R^{21/5} (E^*)^{2/5} m^{-2/5} v_0^{7/5}",
    ),
    (
        r"E_0 = E_{\text{after}} + E_{\text{heat}} + E_{\text{sound}}, \quad (40)",
        r"E_0 = E_{\text{after}} + E_{\text{heat}} + E_{\text{sound}}",
    ),
    (
        r"E_{\text{after}} = e^2 E_0. \quad (41)",
        r"E_{\text{after}} = e^2 E_0",
    ),
    (
        r"m_1 v_0 = m_1 v'_1 + m_2 v'_2 \quad (42)",
        r"m_1 v_0 = m_1 v'_1 + m_2 v'_2",
    ),
    (
        r"\frac{1}{2} m_1 v_0^2 = \frac{1}{2} m_1 v'_1^2 + \frac{1}{2} m_2 v'_2^2 \quad (43)",
        r"\frac{1}{2} m_1 v_0^2 = \frac{1}{2} m_1 {v'_1}^2 + \frac{1}{2} m_2 {v'_2}^2",
    ),
    (
        r"m_1 v_0^2 = m_1 v'_1^2 + m_2 v'_2^2 \quad (44)",
        r"m_1 v_0^2 = m_1 {v'_1}^2 + m_2 {v'_2}^2",
    ),
    (
        r"v'_1 = \frac{m_1 v_0 - m_2 v'_2}{m_1} \quad (45)",
        r"v'_1 = \frac{m_1 v_0 - m_2 v'_2}{m_1}",
    ),
    (
        r"m_1 v_0^2 = m_1 \left(\frac{m_1 v_0 - m_2 v'_2}{m_1} \right)^2 + m_2 v'_2^2 \quad (46)",
        r"m_1 v_0^2 = m_1 \left( \frac{m_1 v_0 - m_2 v'_2}{m_1} \right)^2 + m_2 {v'_2}^2",
    ),
    (
        r"m_1 v_0^2 = \frac{(m_1 v_0 - m_2 v'_2)^2}{m_1} + m_2 v'^2_2 \quad (47)",
        r"m_1 v_0^2 = \frac{(m_1 v_0 - m_2 v'_2)^2}{m_1} + m_2 {v'_2}^2",
    ),
    (
        r"m_1^2 v_0^2 = (m_1 v_0 - m_2 v'_2)^2 + m_1 m_2 v'^2_2 \quad (48)",
        r"m_1^2 v_0^2 = (m_1 v_0 - m_2 v'_2)^2 + m_1 m_2 {v'_2}^2",
    ),
    (
        r"m_1^2 v_0^2 = m_1^2 v_0^2 - 2m_1 m_2 v_0 v'_2 + m_2^2 v'^2_2 + m_1 m_2 v'^2_2 \quad (49)",
        r"m_1^2 v_0^2 = m_1^2 v_0^2 - 2 m_1 m_2 v_0 v'_2 + m_2^2 {v'_2}^2 + m_1 m_2 {v'_2}^2",
    ),
    (
        r"0 = -2m_1 m_2 v_0 v'_2 + m_2^2 v'^2_2 + m_1 m_2 v'^2_2 \quad (50)",
        r"0 = -2 m_1 m_2 v_0 v'_2 + m_2^2 {v'_2}^2 + m_1 m_2 {v'_2}^2",
    ),
    (
        r"0 = -2m_1 m_2 v_0 v'_2 + m_2 v'^2_2 (m_2 + m_1) \quad (51)",
        r"0 = -2 m_1 m_2 v_0 v'_2 + m_2 {v'_2}^2 (m_2 + m_1)",
    ),
    (
        r"2m_1 m_2 v_0 v'_2 = m_2 v'^2_2 (m_1 + m_2) \quad (52)",
        r"2 m_1 m_2 v_0 v'_2 = m_2 {v'_2}^2 (m_1 + m_2)",
    ),
    (
        r"2m_1 v_0 = v'_2 (m_1 + m_2) \quad (53)",
        r"2 m_1 v_0 = v'_2 (m_1 + m_2)",
    ),
    (
        r"\boxed{v'_2 = \frac{2m_1}{m_1 + m_2} v_0} \quad (54)",
        r"v'_2 = \frac{2 m_1}{m_1 + m_2} v_0",
    ),
    (
        r"v'_1 = \frac{m_1 v_0 - m_2 \cdot \frac{2m_1}{m_1 + m_2} v_0}{m_1} \quad (55)",
        r"v'_1 = \frac{m_1 v_0 - m_2 \frac{2 m_1}{m_1 + m_2} v_0}{m_1}",
    ),
    (
        r"v'_1 = v_0 \left(1 - \frac{2m_2}{m_1 + m_2} \right) \quad (56)",
        r"v'_1 = v_0 \left( 1 - \frac{2 m_2}{m_1 + m_2} \right)",
    ),
    (
        r"v'_1 = v_0 \left(\frac{m_1 + m_2 - 2m_2}{m_1 + m_2} \right) \quad (57)",
        r"v'_1 = v_0 \frac{m_1 + m_2 - 2 m_2}{m_1 + m_2}",
    ),
    (
        r"\boxed{v'_1 = \frac{m_1 - m_2}{m_1 + m_2} v_0} \quad (58)",
        r"v'_1 = \frac{m_1 - m_2}{m_1 + m_2} v_0",
    ),
    (
        r"v'_1 = \frac{1 - \mu}{1 + \mu} v_0 \quad (59)",
        r"v'_1 = \frac{1 - \mu}{1 + \mu} v_0",
    ),
    (
        r"v'_2 = \frac{2}{1 + \mu} v_0 \quad (60)",
        r"v'_2 = \frac{2}{1 + \mu} v_0",
    ),
    (
        r"\eta = \frac{E'_2}{E_0} = \frac{\frac{1}{2}m_2v'_2^2}{\frac{1}{2}m_1v_0^2} \quad (61)",
        r"\eta = \frac{E'_2}{E_0} = \frac{\frac{1}{2} m_2 {v'_2}^2}{\frac{1}{2} m_1 v_0^2}",
    ),
    (
        r"\eta = \frac{m_2}{m_1} \cdot \frac{v'_2^2}{v_0^2} = \frac{m_2}{m_1} \cdot \left(\frac{2}{1+\mu} \right)^2 \quad (62)",
        r"\eta = \frac{m_2}{m_1} \frac{{v'_2}^2}{v_0^2} = \frac{m_2}{m_1} \left( \frac{2}{1 + \mu} \right)^2",
    ),
    (
        r"\eta = \mu \cdot \frac{4}{(1+\mu)^2} \quad (63)",
        r"\eta = \mu \frac{4}{(1 + \mu)^2}",
    ),
    (
        r"\boxed{\eta = \frac{4\mu}{(1+\mu)^2}} \quad (64)",
        r"\eta = \frac{4 \mu}{(1 + \mu)^2}",
    ),
    (
        r"\frac{d\eta}{d\mu} = \frac{d}{d\mu} \left[\frac{4\mu}{(1+\mu)^2} \right] \quad (65)",
        r"\frac{d\eta}{d\mu} = \frac{d}{d\mu} \left[ \frac{4 \mu}{(1 + \mu)^2} \right]",
    ),
    (
        r"\frac{d\eta}{d\mu} = \frac{4(1+\mu)^2 - 4\mu \cdot 2(1+\mu)}{(1+\mu)^4} \quad (66)",
        r"\frac{d\eta}{d\mu} = \frac{4 (1 + \mu)^2 - 4 \mu \cdot 2 (1 + \mu)}{(1 + \mu)^4}",
    ),
    (
        r"\frac{d\eta}{d\mu} = \frac{4(1+\mu) - 8\mu}{(1+\mu)^3} = \frac{4 + 4\mu - 8\mu}{(1+\mu)^3} \quad (67)",
        r"\frac{d\eta}{d\mu} = \frac{4 (1 + \mu) - 8 \mu}{(1 + \mu)^3} = \frac{4 + 4 \mu - 8 \mu}{(1 + \mu)^3}",
    ),
    (
        r"\frac{d\eta}{d\mu} = \frac{4(1-\mu)}{(1+\mu)^3} \quad (68)",
        r"\frac{d\eta}{d\mu} = \frac{4 (1 - \mu)}{(1 + \mu)^3}",
    ),
    (
        r"\frac{4(1-\mu)}{(1+\mu)^3} = 0 \quad \Rightarrow \quad 1-\mu = 0 \quad \Rightarrow \quad \boxed{\mu = 1} \quad (69)",
        r"\frac{4 (1 - \mu)}{(1 + \mu)^3} = 0 \Rightarrow 1 - \mu = 0 \Rightarrow \mu = 1",
    ),
    (
        r"\eta_{\max} = \frac{4 \cdot 1}{(1+1)^2} = \frac{4}{4} = \boxed{1} \quad (70)",
        r"\eta_{\max} = \frac{4 \cdot 1}{(1 + 1)^2} = \frac{4}{4} = 1",
    ),
];

#[test]
fn every_equation_of_the_report_is_read() {
    for (number, (source, expected)) in (1..).zip(REPORT) {
        assert_eq!(
            printed(source).as_deref(),
            Ok(*expected),
            "equation ({number})"
        );
        let display = read_display(source, whole(source));
        assert_eq!(display.tag.map(|tag| tag.value), Some(number.to_string()));
        let tagged = source
            .replace(r"\quad (", r"\tag{")
            .replace(&format!("{number})"), &format!("{number}}}"));
        assert_eq!(
            printed(&tagged).as_deref(),
            Ok(*expected),
            "equation ({number}) with \\tag"
        );
        assert_eq!(
            printed(expected.replace(" ;; ", r" \qquad ").as_str()).as_deref(),
            Ok(*expected)
        );
    }
}

#[test]
fn spellings_of_one_term() {
    let spellings: &[(&[&str], &str)] = &[
        (
            &[
                "v'_1",
                "v_1'",
                "v_{1}'",
                "{v'_1}",
                r"v_1^{\prime}",
                r"v^{\prime}_1",
                "{v_1}'",
                "{{v}'}_{1}",
            ],
            "v'_1",
        ),
        (
            &[
                r"v_1^{\prime 2}",
                "v_1'^2",
                "v'_1^2",
                "v'^2_1",
                "{v'_1}^2",
                "{v'_1}^{2}",
            ],
            "{v'_1}^2",
        ),
        (&["E^*", "E^{*}", "(E^*)", "{E}^*"], "E^*"),
        (
            &[
                r"E^{\text{kin}}_0",
                r"E_0^{\mathrm{kin}}",
                r"E_0^\text{kin}",
                r"{E_0}^{\rm kin}",
            ],
            r"E^{\text{kin}}_0",
        ),
        (
            &[
                r"\int_0^a x \, dx",
                r"\int_0^a dx \, x",
                r"\int_0^a \mathrm{d}x\, x",
            ],
            r"\int_{0}^{a} x \, dx",
        ),
        (
            &[r"\int_0^a dx \int_0^x dt \, y t + y"],
            r"\int_{0}^{a} \left( \int_{0}^{x} y t \, dt \right) \, dx + y",
        ),
        (&[r"(E^*)^{2/5}", "{E^*}^{2/5}"], "(E^*)^{2/5}"),
        (&[r"\dot\delta", r"\dot{\delta}"], r"\dot{\delta}"),
        (&[r"\dot v_1", r"\dot{v_1}", r"\dot{v}_{1}"], r"\dot{v}_1"),
        (
            &[
                r"\rho_{\text{air}}",
                r"\rho_\text{air}",
                r"\rho_{\mathrm{air}}",
            ],
            r"\rho_{\text{air}}",
        ),
        (&[r"\Delta E_{\text{total}}"], r"\Delta E_{\text{total}}"),
        (&[r"\eta_{\max}", r"\eta_\max"], r"\eta_{\max}"),
        (
            &[r"v_{\rm max}", r"v_{\text{max}}", r"v_{{\rm max}}"],
            r"v_{\text{max}}",
        ),
        (
            &[r"v_{1,\rm max}", r"v_{1,\mathrm{max}}"],
            r"v_{1,\text{max}}",
        ),
        (&[r"E_{\rm 1s}", r"E_{\mathrm{1s}}"], r"E_{\text{1s}}"),
        (
            &[
                r"{\rm kin} x",
                r"\mathrm{kin} x",
                r"\left(\rm kin\right) x",
                r"{ \rm kin}x",
            ],
            r"\text{kin} x",
        ),
        (&[r"x_{\rm a} b", r"{x_{\rm a}} b"], r"x_{\text{a}} b"),
        (&[r"{\bf F}_1", r"\mathbf{F}_1"], r"\mathbf{F}_1"),
        (&[r"\hat{\bf n}"], r"\hat{\mathbf{n}}"),
        (&[r"{\cal L}t", r"\mathcal Lt"], r"\mathcal{L} t"),
        (&[r"{\it x}y", r"\mathit{x} y"], "x y"),
        (
            &[
                r"\frac{{\rm d}\eta}{{\rm d}\mu}",
                r"\frac{\rm d\eta}{\rm d\mu}",
            ],
            r"\frac{d\eta}{d\mu}",
        ),
        (
            &[r"\frac{\rm a}{\rm b}", r"\frac{{\rm a}}{{\rm b}}"],
            r"\frac{\text{a}}{\text{b}}",
        ),
        (&[r"\frac1{\rm b}x"], r"\frac{1}{\text{b}} x"),
        (
            &[r"\int_0^1 \frac{x}{2}{\rm d}x"],
            r"\int_{0}^{1} \frac{x}{2} \, dx",
        ),
        (
            &[r"5\,{\rm m/s^2}", r"5\,\mathrm{m/s^2}"],
            r"5 (\unit{m} \unit{s}^{-2})",
        ),
        (
            &[
                r"\frac12 m",
                r"\cfrac{1}{2} m",
                r"\frac1{2}m",
                r"\tfrac{1}2 m",
                r"1/2m",
            ],
            r"\frac{1}{2} m",
        ),
        (&["0.50", "0.5"], "0.5"),
        (&["3!"], "6"),
        (&["3!^2 x", r"{3!}\!^2 x"], "6^2 x"),
        (&[r"\binom{n}{0}"], "1"),
        (&[r"\binom n1"], "n"),
        (
            &[r"\binom{n}{2}", r"\dbinom n2", r"\frac{n(n-1)}{2}"],
            r"\frac{n (n - 1)}{2}",
        ),
        (
            &[r"\tbinom{n+1}{3}"],
            r"\frac{(n + 1) ((n + 1) - 1) ((n + 1) - 2)}{6}",
        ),
        (
            &[r"\sqrt{x}", r"\sqrt x", r"\sqrt[2]{x}", "x^{0.5}"],
            r"\sqrt{x}",
        ),
        (&[r"\sqrt[3]{x}"], r"\sqrt[3]{x}"),
        (&["x^{1000000000}"], "x^{1000000000}"),
        (
            &["a b c", r"a \cdot b \times c", "a*b*c", r"a\,b\;c"],
            "a b c",
        ),
        (&["(a+b)+c"], "(a + b) + c"),
        (&[r"\left(a\right)b", r"\bigl(a\bigr) b"], "a b"),
        (
            &["|x|", r"\lvert x \rvert", r"\left|x\right|"],
            r"\left| x \right|",
        ),
        (
            &[r"\sin 2 \pi x", r"\sin(2\pi x)"],
            r"\sin\left( 2 \pi x \right)",
        ),
        (
            &[
                r"l \cos\theta\dot\theta",
                r"l \cos\theta\,\dot{\theta}",
                r"l \cos(\theta) \cdot \dot\theta",
            ],
            r"l \cos\left( \theta \right) \dot{\theta}",
        ),
        (
            &[r"\sin^2\theta\dot\phi^2"],
            r"\left( \sin\left( \theta \right) \right)^2 \dot{\phi}^2",
        ),
        (
            &[r"\sin 2\dot\theta t"],
            r"\sin\left( 2 \dot{\theta} t \right)",
        ),
        (
            &[r"\cos\theta\,\theta'", r"\cos\theta \theta'"],
            r"\cos\left( \theta \right) \theta'",
        ),
        (&[r"\cos\omega' t'"], r"\cos\left( \omega' t' \right)"),
        (
            &[
                r"\cos\theta\frac{d\theta}{dt}",
                r"\cos\theta \, \frac{\mathrm d\theta}{\mathrm dt}",
            ],
            r"\cos\left( \theta \right) \frac{d\theta}{dt}",
        ),
        (
            &[r"\sin\theta\,d\phi", r"\sin(\theta) d \phi"],
            r"\sin\left( \theta \right) d \cdot \phi",
        ),
        (
            &[r"\sin\theta d\theta"],
            r"\sin\left( \theta \right) d \cdot \theta",
        ),
        (&[r"\cos k d"], r"\cos\left( k d \right)"),
        (
            &[
                r"\sum_{i=1}^k u_i",
                r"\sum^{k}_{i=1} u_i",
                r"u_1 + u_2 + \cdots + u_k",
            ],
            r"\sum_{i = 1}^{k} u_i",
        ),
        (&[r"m_1 v_1 + \dots + m_k v_k"], r"\sum_{i = 1}^{k} m_i v_i"),
        (&[r"u_1 + \cdots + u_5"], r"\sum_{i = 1}^{5} u_i"),
        (
            &[r"a + u_1 i + u_2 i + \ldots + u_n i - b"],
            r"a + \sum_{j = 1}^{n} u_j i - b",
        ),
        (
            &[r"\frac{d^2 x}{dt^2}"],
            r"\frac{d}{dt} \left[ \frac{dx}{dt} \right]",
        ),
        (
            &[r"\frac{\mathrm d\eta}{\mathrm{d}\mu}"],
            r"\frac{d\eta}{d\mu}",
        ),
        (&[r"\frac{d}{d+1}"], r"\frac{d}{d + 1}"),
        (
            &[
                r"\dv{x}{t}",
                r"\dv*{x}{t}",
                r"\derivative{x}{t}",
                r"\frac{\mathop{}\!\mathrm{d}x}{\dd t}",
            ],
            r"\frac{dx}{dt}",
        ),
        (
            &[r"\dv[2]{x}{t}"],
            r"\frac{d}{dt} \left[ \frac{dx}{dt} \right]",
        ),
        (
            &[
                r"\dv{t}\qty(a t)",
                r"\dv{t}\quantity[a t]",
                r"\dv{t}\qty{a t}",
            ],
            r"\frac{d}{dt} \left[ a t \right]",
        ),
        (
            &[
                r"\abs{x} + \qty|y| + \abs*{\dv{x}{t}}",
                r"\norm{x} + \qty|y| + \norm{\dv{x}{t}}",
            ],
            r"\left| x \right| + \left| y \right| + \left| \frac{dx}{dt} \right|",
        ),
        (
            &[r"\int_0^T f \dd{t}", r"\int_0^T f \mathop{}\!\mathrm{d}t"],
            r"\int_{0}^{T} f \, dt",
        ),
        (&[r"\eval{x^2}_{x=0}^{x=L}"], r"L^2 - 0^2"),
        (
            &[r"\va{F} + \vb{p} + \vb*{q}"],
            r"\vec{F} + \mathbf{p} + \boldsymbol{q}",
        ),
        (&[r"\qty{5}{m}", r"\qty[a=b]{5}{m}"], r"5 \unit{m}"),
        (
            &[
                r"\frac{\partial E}{\partial v}",
                r"\pdv{E}{v}",
                r"\partial_v E",
            ],
            r"\frac{\partial E}{\partial v}",
        ),
        (
            &[
                r"\frac{\partial^2 f}{\partial x \partial y}",
                r"\pdv{f}{x}{y}",
                r"\partial_x \partial_y f",
            ],
            r"\frac{\partial^2 f}{\partial x \partial y}",
        ),
        (
            &[
                r"\frac{\partial^2}{\partial x_1^2} (f + g)",
                r"\pdv[2]{x_1}(f + g)",
                r"\partial_{x_1}^2 (f + g)",
            ],
            r"\frac{\partial^2}{\partial x_1^2} \left[ f + g \right]",
        ),
        (
            &[
                r"\left(\frac{\partial U}{\partial V}\right)_T",
                r"\qty(\pdv{U}{V})_{T}",
                r"\left. \frac{\partial U}{\partial V} \right|_T",
            ],
            r"\left( \frac{\partial U}{\partial V} \right)_{T}",
        ),
        (
            &[r"T \left(\frac{\partial S}{\partial T}\right)_V"],
            r"T \left( \frac{\partial S}{\partial T} \right)_{V}",
        ),
        (
            &[r"\pdv{\rho}{d}", r"\frac{\partial \rho}{\partial d}"],
            r"\frac{\partial \rho}{\partial d}",
        ),
        (
            &[r"\left(\frac{\partial^2 F}{\partial V \partial T}\right)_{N, x'}"],
            r"\left( \frac{\partial^2 F}{\partial V \partial T} \right)_{N, x'}",
        ),
        (
            &[r"2 \left(\frac{\partial U}{\partial V}\right)_T^2 \frac{\partial f}{\partial x'}"],
            r"2 \left( \left( \frac{\partial U}{\partial V} \right)_{T} \right)^2 \frac{\partial f}{\partial x'}",
        ),
        (
            &[r"\lim_{\mu \to \infty} \eta"],
            r"\lim_{\mu \to \infty} \eta",
        ),
        (&[r"v_0(1-\mu)^2"], r"v_0 (1 - \mu)^2"),
        (
            &["m[1 + x]", r"m\left\{1 + x\right\}", "m(1 + x)"],
            "m (1 + x)",
        ),
        (&["2[a+b]"], "2 (a + b)"),
        (&["(a)[b]"], "a b"),
        (
            &[
                r"\mathrm{Var}(X) + 1",
                r"\operatorname{Var}\left[ X \right] + 1",
            ],
            r"\text{Var}(X) + 1",
        ),
        (
            &[r"\operatorname{Var}(aX)^2 b", r"{\rm Var}\{aX\}^2b"],
            r"\text{Var}(a X)^2 b",
        ),
        (
            &[r"\left\langle x^{2}\right\rangle^2", r"⟨x²⟩^2"],
            r"\langle x^2 \rangle^2",
        ),
        (
            &[r"P(A|B)P(X\ge3)", r"P(A \mid B) P(X \geqslant 3)"],
            r"P(A \mid B) P(X \geq 3)",
        ),
        (
            &[r"k[\mathrm{CO_3^{2-}}]_0^2", r"k [\text{CO}_3^{2-}]^2_0"],
            r"k [\text{CO3}^{2-}]_0^2",
        ),
        (
            &[r"\mathrm{Var} \cdot \mathrm{Re} \cdot (a + b)"],
            r"\text{Var} \cdot \text{Re} \cdot (a + b)",
        ),
        (&[r"\mathrm{Re}^2 x"], r"\text{Re}^2 x"),
        (
            &[r"m\vec a + \frac{1}{2}(\vec b - \frac{\vec c}{3}) \times 2"],
            r"m \vec{a} + \frac{1}{2} \left( \vec{b} - \frac{\vec{c}}{3} \right) \cdot 2",
        ),
        (
            &[r"m \frac{d\mathbf v}{dt} U(\mathbf r)"],
            r"m \frac{d\mathbf{v}}{dt} U(\mathbf{r})",
        ),
        (
            &[r"\hat y^2 \cdot \hat y / \hat x + \hat\beta x"],
            r"\frac{\hat{y}^2 \hat{y}}{\hat{x}} + \hat{\beta} x",
        ),
        (&["u^{(n+1)/2}"], r"u^{\frac{n + 1}{2}}"),
        (&["u^{(2)/3}"], "u^{2/3}"),
        (&["u^{-(2)}"], "u^{-2}"),
        (&["u_{(2)}^2"], "u_{(2)}^2"),
        (&["2^{(n)}"], "2^n"),
        (&["(a + b)^{-1}(c + d)"], "(a + b)^{-1} (c + d)"),
        (&[r"x^{-1} \cdot (a + b)"], r"x^{-1} \cdot (a + b)"),
        (&["x^2(a + b)", "{x^2}(a + b)"], "x^2 (a + b)"),
        (&["x^2(E^*)^2"], "x^2 (E^*)^2"),
        (&[r"\underbrace{a b}_{\text{two}} + c"], "a b + c"),
        (
            &[r"\int_a^b \frac{dx}{x}", r"\int_a^b \frac{1}{x} \, dx"],
            r"\int_{a}^{b} \frac{1}{x} \, dx",
        ),
        (
            &[r"\int_a^b \frac{p x \, dx}{q}"],
            r"\int_{a}^{b} \frac{p x}{q} \, dx",
        ),
        (
            &[r"\int_a^b k \frac{dx'}{x'} + c"],
            r"\int_{a}^{b} k \frac{1}{x'} \, dx' + c",
        ),
        (
            &[
                r"\int_a^\infty f \, dx",
                r"\int_{a}^{+\infty} f \, dx",
                r"\int^\infty_a f \, dx",
            ],
            r"\lim_{x' \to \infty} \int_{a}^{x'} f \, dx",
        ),
        (
            &[r"\sum_{k=0}^\infty r^k", r"\sum_{k=0}^{+\infty} r^k"],
            r"\lim_{k' \to \infty} \sum_{k = 0}^{k'} r^k",
        ),
        (
            &[r"\int_{-\infty}^b x' \, dx"],
            r"\lim_{x'' \to -\infty} \int_{x''}^{b} x' \, dx",
        ),
        (
            &[
                r"2 \left[ x^2 \right]_{x=a}^{x=b}",
                r"2 [x^2]_{x=a}^b",
                r"2 \left[x^2\right]^{b}_{x = a}",
            ],
            r"2 (b^2 - a^2)",
        ),
        (
            &[
                r"k \lambda \left[ -\frac{1}{x} \right]_{x=a}^{x=b}",
                r"k \lambda \cdot [-\frac1x]_{x=a}^b",
            ],
            r"k \lambda \left( -\frac{1}{b} - \left( -\frac{1}{a} \right) \right)",
        ),
        (
            &[r"\left[ \frac{k}{x} \right]_{x=a}^\infty"],
            r"\lim_{x \to \infty} \frac{k}{x} - \lim_{x \to a} \frac{k}{x}",
        ),
        (&[r"k \left. x^2 \right|_{x=a}^{x=b}"], r"k (b^2 - a^2)"),
        (
            &[r"k x^2 \Big|_{x=a}^{x=b}", r"k x^2 |_{x=a}^b"],
            r"\lim_{x \to b} k x^2 - \lim_{x \to a} k x^2",
        ),
        (
            &[
                r"\left. x^2 \right|_{x=3}",
                r"x^2 \big|_{x=3}",
                r"[x^2]_{x=3}",
            ],
            "3^2",
        ),
        (
            &[
                r"\left. \frac{dU}{dx} \right|_{x=x_0}",
                r"\frac{dU}{dx} \bigg\rvert_{x = x_0}",
            ],
            r"\lim_{x \to x_0} \frac{dU}{dx}",
        ),
        (&["h/2\\pi", r"h/(2\pi)"], r"\frac{h}{2 \pi}"),
        (&[r"4/3 \pi r^3"], r"\frac{4}{3} \pi r^3"),
        (&[r"y |_{t=0} + 1"], r"\lim_{t \to 0} y + 1"),
        (&["x(0)", r"x\left(0\right)"], "x(0)"),
        (
            &[r"\int_a^b \frac{\int_a^c e\,dx}{a}\,dx"],
            r"\int_{a}^{b} \frac{\int_{a}^{c} e \, dx}{a} \, dx",
        ),
    ];
    for (sources, expected) in spellings {
        for source in *sources {
            let expr = read_expr(source, whole(source)).map(|expr| latex(&expr));
            assert_eq!(expr.as_deref(), Ok(*expected), "{source}");
        }
    }
}

#[test]
fn statements_and_what_separates_them() {
    let cases = [
        (r"\boxed{k = n}", "k = n"),
        (
            r"\boxed{a = b \Rightarrow c = d}.",
            r"a = b \Rightarrow c = d",
        ),
        (r"\boxed{\boxed{a} = b \times}", r"a = b \quad \times"),
        (r"a = b \text{ and } c \not= d", r"a = b ;; c \neq d"),
        (
            r"\begin{aligned} a &= b \\ &= c, \\ d &= e \end{aligned}",
            "a = b = c ;; d = e",
        ),
        (
            r"\begin{aligned} a &= b \\ &\quad + c \end{aligned}",
            "a = b + c",
        ),
        (
            r"\begin{aligned}[t] a &= b \\ c &= d \end{aligned}",
            "a = b ;; c = d",
        ),
        (
            r"\begin{gathered} [b] a = b \\ c = d \end{gathered}",
            "a = b ;; c = d",
        ),
        (r"a = b \iff c = d", r"a = b \iff c = d"),
        (
            r"\left\{ \begin{aligned} a &= b \\ c &= d \end{aligned} \right.",
            "a = b ;; c = d",
        ),
        (
            r"\left\lbrace\begin{array}{l} a = b \\ c < d \end{array}\right. \quad (3)",
            "a = b ;; c < d",
        ),
        (
            r"\left\{\begin{array}{rcl} a & = & b, \\[2mm] c & \leq & d \\ \end{array}\right.",
            r"a = b ;; c \leq d",
        ),
        (r"u_1 = \cdots = u_k = v_0", r"u_1 = \dots = u_k = v_0"),
        (
            r"x \stackrel{?}{\leq} y \quad ✗",
            r"x \stackrel{?}{\leq} y \quad \times",
        ),
        (
            r"E_{\text{heat}} \gg E_{\text{sound}}",
            r"E_{\text{heat}} \gg E_{\text{sound}}",
        ),
        (r"a := b", "a = b"),
        (
            r"v = \int g \, dt = g t + v_0",
            r"\frac{dv}{dt} = g = \frac{d}{dt} \left[ g t \right]",
        ),
        (
            r"\int x e^x \, dx = x e^x - 2 \int \frac{dx}{2} + C",
            r"x e^x = \frac{d}{dx} \left[ x e^x \right] - 2 \cdot \frac{1}{2}",
        ),
        (
            r"a = \sinh 2x + \log_{10} y + \lg y + \sin 30^\circ",
            r"a = \frac{\exp\left( 2 x \right) - \exp\left( -2 x \right)}{2} + \frac{\ln\left( y \right)}{\ln\left( 10 \right)} + \frac{\ln\left( y \right)}{\ln\left( 10 \right)} + \sin\left( \frac{30 \pi}{180} \right)",
        ),
        (
            r"a = \ln \cos x + \ln \sin 2 y",
            r"a = \ln\left( \cos\left( x \right) \right) + \ln\left( \sin\left( 2 y \right) \right)",
        ),
        (
            r"\alpha = \arctan\frac{y}{x} + \arcsin x - \arccos(2 x)",
            r"\alpha = \arctan\left( \frac{y}{x} \right) + \arcsin\left( x \right) - \arccos\left( 2 x \right)",
        ),
        (
            r"\Delta G^\circ = \mu^{\circ} c_{\mathrm{H_2O}} - {E^\circ}^2 \mathrm{C_6H_{12}O_6}",
            r"\Delta G^\circ = \mu^\circ c_{\text{H2O}} - (E^\circ)^2 \text{C6H12O6}",
        ),
        (
            r"\boxed{\begin{aligned} a &= b \\ c &= d \end{aligned}}",
            "a = b ;; c = d",
        ),
        (
            r"\Rightarrow \boxed{a = 1{,}5 b,} \quad \underline{\underline{c = d.}}",
            "a = 1.5 b ;; c = d",
        ),
        (
            r"a \overset{!}{=} b \stackrel{\eqref{x_1}}{\leq} c \overset{\text{def}}= d \overset{(3a)}{=} \underline{f + g}",
            r"a = b \leq c = d = f + g",
        ),
        (
            r"V_+ = V_- + 10\,000\,x_{\bar y} + w_{1{,}2} = \text{const.}, \quad n = 1, 2, \dots, \quad (n > 3)",
            r"V_+ = V_- + 10000 x_{\bar{y}} + w_{1,2} = \text{const} \quad \text{if } n > 3",
        ),
        (
            r"f = g = \begin{cases} a, & x < 0, \\ b & \text{for } x = 0 \text{ and } y > 0, \\[2pt] -c, & x > 0. \end{cases}",
            r"f = g ;; g = a \quad \text{if } x < 0 ;; g = b \quad \text{if } x = 0 \text{ and } y > 0 ;; g = -c \quad \text{if } x > 0",
        ),
        (
            r"f = \begin{dcases} a & x < 0 \\ b & \text{otherwise} \end{dcases}",
            r"f = a \quad \text{if } x < 0 ;; f = b \quad \text{if } x \geq 0",
        ),
        (
            r"\begin{cases} a + b &= c \\ a - b &= d \end{cases}",
            "a + b = c ;; a - b = d",
        ),
        (
            r"a = b = c \quad \text{if } x \neq 0, \quad d = e",
            r"a = b = c \quad \text{if } x \neq 0 ;; d = e",
        ),
        (
            r"a = \qty[per-mode = symbol]{-1.5e3}{\kilo\gram\per\cubic\metre\squared} + \SI{2}{MHz}",
            r"a = -1500 \unit{kg} \unit{m}^{-6} + 2 (1000000 \unit{s}^{-1})",
        ),
        (
            r"a = 5\,\mathrm{km}/\mathrm{h} + 2\,\mathrm{mm^2}",
            r"a = \frac{5 (1000 \unit{m})}{3600 \unit{s}} + 2 (0.000001 \unit{m}^2)",
        ),
        (
            r"a = 9.81\,\frac{\mathrm{m}}{\mathrm{s}^2} + \frac{5\,\mathrm{m}}{\mathrm{s}} + 5\,\text{mm}\cdot\text{s}",
            r"a = 9.81 (\unit{m} \unit{s}^{-2}) + \frac{5 \unit{m}}{\unit{s}} + 5 (0.001 \unit{m}) \unit{s}",
        ),
        (
            r"a = \mathrm{m} + 2 \text{s} + \frac{\mathrm{kg}}{2} + 2 \frac{\mathrm{g}}{\mathrm{M}} + 2\frac{\text{m}}{\text{s}}",
            r"a = \text{m} + 2 \text{s} + \frac{\text{kg}}{2} + 2 \cdot \frac{\text{g}}{\text{M}} + 2 \cdot \frac{\text{m}}{\text{s}}",
        ),
        (
            r"a = 4\,\Omega^2 + 4\Omega + 4\,\mu \mathrm{m} + 4\,\mu\,\mathrm{m} + 4\,\Omega \sin t + 4\,\Omega",
            r"a = 4 \Omega^2 + 4 \Omega + 4 (0.000001 \unit{m}) + 4 \mu \text{m} + 4 \Omega \sin\left( t \right) + 4 (\unit{kg} \unit{m}^2 \unit{s}^{-3} \unit{A}^{-2})",
        ),
    ];
    for (source, expected) in cases {
        assert_eq!(printed(source).unwrap_or_default(), expected, "{source}");
    }
    let directive = r"u_i \neq 0, x ≥ 1 and −y < 2";
    let read = read_formulas(directive, whole(directive)).unwrap();
    let read: Vec<String> = read.iter().map(latex_statement).collect();
    assert_eq!(read, [r"u_i \neq 0", r"x \geq 1", "-y < 2"]);
    assert_eq!(read_symbol("v_1'").unwrap().name(), "v'_1");
}

#[test]
fn places_are_exact() {
    let source = r"xx a - 2b + c \stackrel{?}{=} (d + f) \tag{7} \label{eq:x} yy";
    let display = read_display(source, Span::new(3, source.len() - 3));
    assert_eq!(display.tag.unwrap().value, "7");
    assert_eq!(display.label.unwrap().value, "eq:x");
    let statements = display.statements.unwrap();
    let [statement] = statements.as_slice() else {
        panic!("one statement")
    };
    let [Clause::Chain { sides, links }] = statement.clauses.as_slice() else {
        panic!("one chain")
    };
    let text = |span: &Span| &source[span.range()];
    assert_eq!(
        sides[0].terms.iter().map(text).collect::<Vec<_>>(),
        ["a", "- 2b", "+ c"]
    );
    assert_eq!(
        sides[1].terms.iter().map(text).collect::<Vec<_>>(),
        ["d", "+ f"]
    );
    assert_eq!(text(&links[0].span), r"\stackrel{?}{=}");
    assert_eq!(text(&statement.span), r"a - 2b + c \stackrel{?}{=} (d + f)");
}

/// How near the right side is meant, as a share of it.
fn rounding(source: &str) -> Option<(String, Precision)> {
    let statements = read_display(source, whole(source)).statements.unwrap();
    let Clause::Chain { sides, .. } = &statements[0].clauses[0] else {
        panic!("a chain")
    };
    let rounding = sides.last()?.rounding.as_ref()?;
    Some((rounding.share.to_string(), rounding.precision))
}

#[test]
fn numbers_say_how_near_they_are_meant() {
    let share = |share: &str, precision| Some((share.to_owned(), precision));
    for source in [
        r"g = 9.79",
        r"g = -9.79",
        r"g = 9{,}79\,\mathrm{m/s^2}",
        r"g = 9.79 \cdot 10^{-19}\,\mathrm{J}",
        r"g = \qty{9.79e3}{m}",
    ] {
        assert_eq!(
            rounding(source),
            share("1/1958", Precision::Decimal),
            "{source}"
        );
    }
    assert_eq!(
        rounding(r"g \approx 300\,\mathrm{N}"),
        share("1/6", Precision::Whole)
    );
    for stated in [r"m = 5.0 \pm 0.1", r"m = (5 \pm 0.1)\,\mathrm{kg}"] {
        assert_eq!(
            rounding(stated),
            share("1/50", Precision::Stated),
            "{stated}"
        );
    }
    // What is computed, 0, and what has a name is no rounded number.
    for exact in [
        r"g = 9.79 \cdot 2",
        r"g = 9.79/3",
        r"g = 0.00",
        r"g = 9.79 x",
        r"g = \frac{1.5}{2}",
    ] {
        assert_eq!(rounding(exact), None, "{exact}");
    }
}

#[test]
fn what_has_an_uncertainty_is_nothing_exactly() {
    let read = |source: &str| {
        let statements = read_display(source, whole(source)).statements.unwrap();
        latex_statement(&statements[0])
    };
    assert_eq!(read(r"m = 5.0 \pm 0.1"), r"m \approx 5");
    assert!(read(r"x = a \pm b").ends_with("= 0"));
}

#[test]
fn the_number_is_found_even_where_the_rest_is_unreadable() {
    let source = r"\foo{ = \text{ \tag{(12a)}";
    let display = read_display(source, whole(source));
    assert_eq!(display.tag.unwrap().value, "12a");
    assert!(display.statements.is_err());
}

/// Source, the guilty token, the beginning of the message.
const REFUSALS: &[(&str, &str, &str)] = &[
    (
        "0 < a, b < 1",
        "0 < a, b < 1",
        "whether both lie between these bounds is not clear",
    ),
    (
        "k = 1.38e-23",
        "1.38e-23",
        "whether `1.38e-23` has a power of ten or a factor is not clear",
    ),
    (
        r"s = \sum_{k=1}^{n} {k + 1}",
        "{k + 1}",
        "TeX does not print these braces",
    ),
    (
        r"y = \frac{d}{dt} {t^2 + 1}",
        "{t^2 + 1}",
        "TeX does not print these braces",
    ),
    (
        r"y = \lim_{x \to 0} {x + a}",
        "{x + a}",
        "TeX does not print these braces",
    ),
    (
        r"a = \frac{dT}{dx}(T)",
        "(",
        "whether this is a factor or says where the slope is taken is not clear",
    ),
    (
        r"a = \frac{dT}{dx}(q)",
        "(",
        "whether this is a factor or says where the slope is taken is not clear",
    ),
    (
        r"\frac{d\ln y}{d\log x} = n",
        r"\log",
        "derivatives are read with respect to a symbol, not to a term",
    ),
    (
        r"\frac{d^2x}{ds\,dt} = q",
        "d",
        "derivatives with respect to several variables",
    ),
    (
        r"\frac{Du}{Dt} = g",
        r"\frac",
        "derivatives along a flow are not read",
    ),
    (
        r"d/dt(m v) = F",
        "d/dt",
        "this may be a derivative or a quotient of products",
    ),
    (
        r"d^2x/dt^2 = a",
        "d^2x/dt",
        "this may be a derivative or a quotient of products",
    ),
    (
        r"a = \int_0^1 dx \, y \, dz",
        "d",
        "this is a second differential: an integral has one",
    ),
    (
        r"y = \mathrm{artanh}\,x",
        r"\mathrm{artanh}",
        "whether `\\text{artanh}` is applied to what follows",
    ),
    (r"a = \farc{1}{2}", r"\farc", r"`\farc` is not known"),
    (
        r"a = b \pm c = d \pm e",
        r"\pm",
        r"`\pm` states two equations at once",
    ),
    (
        r"a \leq b \mp c",
        r"\mp",
        r"`\pm` states two equations at once",
    ),
    (
        r"m = 5 \pm 1",
        r"5 \pm 1",
        "whether this is a value with its uncertainty or two values is not clear",
    ),
    (
        r"\int_{-\infty}^\infty f \, dx = 1",
        r"\int_{-\infty}^\infty",
        "of the limits of an integral only one may be infinite",
    ),
    (
        r"\int_a^b \frac{dx}{x} y = 1",
        "y",
        "whether this is integrated too is not clear",
    ),
    (
        r"\int_a^b \frac{dx}{x} / y = 1",
        "/",
        "whether this is integrated too is not clear",
    ),
    (
        r"a = [x^2]_0^1",
        r"[x^2]_0^1",
        "what runs between these limits is not told",
    ),
    (
        r"a = [y]_{x=0}^{x=1}",
        r"[y]_{x=0}^{x=1}",
        "nothing in this bracket runs with `x`",
    ),
    (
        r"a = [x^2]_0",
        "_0",
        "of the limits after this one is missing",
    ),
    (
        r"a = x + x^2 |_{x=0}^{x=1}",
        r"x^2 |_{x=0}^{x=1}",
        "whether the whole sum is meant here, or its last term alone, is not clear",
    ),
    (
        r"a = \left. x^2 \right)",
        r"\right",
        r"`\right|` is expected here",
    ),
    (r"a = \left. x^2", r"\left.", "this is never closed"),
    (
        r"a = y |_0^1",
        r"y |_0^1",
        "what runs between these limits is not told",
    ),
    (
        r"\partial f = 0",
        r"\partial",
        r"`\partial` is read only in derivatives",
    ),
    (
        r"F = -\grad V",
        r"\grad",
        r"`\grad` is not read: the notation has no vector calculus",
    ),
    (
        r"\comm{x}{p} = 0",
        r"\comm",
        r"`\comm` is not read: the notation has no brackets of operators",
    ),
    (
        r"a = \exp(\int f \, dx)",
        r"\int",
        "an integral without limits is read only as a side of an equation, or a summand of one",
    ),
    (
        r"W = \int F \, dx = F L",
        r"W",
        "between which limits is integrated is not told: this does not run with `x`",
    ),
    (
        r"\int \frac{dv}{v} = \int g \, dt = g t",
        r"\int",
        "integrals over different variables cannot be compared without limits",
    ),
    (
        r"m = \int_V \rho \, dV",
        r"\int_V",
        "of the limits of this integral one is missing",
    ),
    (
        r"\partial_\mu f = 0",
        r"\partial_\mu",
        "what is differentiated by here is an index, or not clear",
    ),
    (
        r"\partial_x f g = 0",
        "g",
        "whether this is differentiated too is not clear",
    ),
    (
        r"\frac{\partial^2 f}{\partial x} = 0",
        r"\frac{\partial^2 f}{\partial x}",
        "the orders above and below in this derivative do not agree, or are too high",
    ),
    (
        r"\left( \frac{\partial U}{\partial V} \right)_{T^2} = 0",
        r"T^2",
        "this cannot be held fixed",
    ),
    (
        r"\int x u' \, dx = x u - \int u \, dx",
        r"\int",
        "whether something in this depends on `x` is not told",
    ),
    (
        r"\int y \, dx = u v - \int w \, dx",
        r"u v - \int w \, dx",
        "between which limits is integrated is not told: this does not run with `x`",
    ),
    (
        r"v_12 = 0",
        "12",
        "TeX takes only the `1` of `12` into the subscript",
    ),
    (
        r"x^10 = 0",
        "10",
        "TeX takes only the `1` of `10` into the superscript",
    ),
    (r"x^a^b = 0", "^b", "this is a second superscript"),
    (r"(x)^a^b = 0", "^", "this is a second script"),
    (r"a + b", "a + b", "this is a term, not a statement"),
    (
        r"a = = b",
        "=",
        "a term is missing between two relation signs",
    ),
    (r"a =", "=", "a term is missing after this relation sign"),
    (r"= a", "=", "a term is missing before this relation sign"),
    (r"a = {b", "{", "this brace is never closed"),
    (r"a = b}", "}", "this `}` closes nothing"),
    (r"a = (b", "(", "this is never closed"),
    (r"a = (b]", "]", "`)` is expected here"),
    (r"a = b)", ")", "`)` closes nothing"),
    (r"a = \left( b )", ")", r"`\right)` is expected here"),
    (r"a = {}", "=", "a term is missing after this relation sign"),
    (r"a = ()", ")", "a term is missing before `)`"),
    (r"a = 2 3", "3", "two numbers stand side by side"),
    (r"a = 2 \frac12", r"\frac12", "this may be a mixed number"),
    (
        r"a = {b + c} d",
        "{b + c}",
        "TeX does not print these braces",
    ),
    (r"a = b + - c", "-", "two signs stand side by side"),
    (
        r"a = b \text{ unless } c = d",
        r"\text{ unless }",
        "the words `unless` cannot be read here",
    ),
    (
        r"a = \ln x (b+c)",
        "(b+c)",
        "where the argument of this function ends is not clear",
    ),
    (
        r"a = \frac{d}{dx}(f) g",
        "g",
        "whether this is differentiated too",
    ),
    (
        r"a = \int_0^1 x",
        r"\int_0^1",
        "this integral has no differential",
    ),
    (
        r"a = u_1 + \cdots + v_k",
        r"\cdots",
        "the terms around these dots",
    ),
    (
        r"a = u_2 + \cdots + u_k",
        r"\cdots",
        "a sum with dots must start at the index 1",
    ),
    (
        r"a = \sum_{i=1}^k u_{i+1}",
        "u_{i+1}",
        "the index of the sum stands in a longer subscript",
    ),
    (
        r"u_1 = v_2 = \dots = u_k",
        "v_2",
        "the sides around these dots",
    ),
    (
        r"a = c \% b",
        r"\%",
        r"`\%` is read only right after a number",
    ),
    (r"é = 1", "é", "the character `é` is not known"),
    (r"a = \infty", r"\infty", r"`\infty` is no number"),
    (r"a = x!", "!", "only factorials of numerals are read"),
    (r"a = 3!!", "!", "double factorials are not read"),
    (r"a = 0.5!", "0.5!", "factorials are read of whole numbers"),
    (r"a = 2 3!", "3!", "two numbers stand side by side"),
    (
        r"a = \binom{n}{k}",
        "{k}",
        "binomial coefficients are read only with a whole number",
    ),
    (
        r"a = \binom{\binom{n}{9}}{2}",
        r"\binom{\binom{n}{9}}{2}",
        "what stands above in this binomial coefficient is too long",
    ),
    (
        r"\begin{array}{l} a = b \end{array}",
        r"\begin{array}",
        "the environment `array` is not read",
    ),
    (
        r"a = \begin{cases} b & c > 0",
        r"\begin{cases}",
        "the environment `cases` is never ended",
    ),
    (
        r"a = \begin{cases} b & c > 0 \\ d \end{cases}",
        "d",
        "when this case applies is not said",
    ),
    (
        r"\begin{cases} a = b & c > 0 \end{cases}",
        "&",
        "a second column is read only beside the cases",
    ),
    (
        r"\left\{ \begin{array}{ll} a = b & c > 0 \end{array} \right.",
        r"\begin{array}",
        "the environment `array` cannot start here",
    ),
    (
        r"a = b \Rightarrow c = \begin{cases} d & e > 0 \end{cases}",
        r"a = b \Rightarrow c = \begin{cases} d & e > 0 \end{cases}",
        "cases are not read in an implication",
    ),
    (
        r"a = b \text{ if } c > 0, d > 0",
        ",",
        "whether another condition follows",
    ),
    (
        r"a = E[X^2] - b",
        "E[X^2]",
        "whether `E` is applied to what follows",
    ),
    (
        r"a = b + E_0\left[X\right]^2",
        r"E_0\left[X\right]",
        "whether `E_0` is applied",
    ),
    (
        r"a = \mathbb{E} X",
        r"\mathbb{E}",
        r"whether `\mathbb{E}` is applied",
    ),
    (
        r"a = \mathbb{P}(X + 1)",
        r"\mathbb{P}(X + 1)",
        r"whether `\mathbb{P}` is applied",
    ),
    (
        r"a = \mathrm{Arg}(aX)",
        r"\mathrm{Arg}(aX)",
        r"whether `\text{Arg}` is applied",
    ),
    (
        r"a = {\rm Det}\{b + c\}",
        r"{\rm Det}\{b + c\}",
        r"whether `\text{Det}` is applied",
    ),
    (
        r"a = \mathrm{Var} X",
        r"\mathrm{Var}",
        r"whether `\text{Var}` is applied",
    ),
    (
        r"a = \text{Re}(b + c)",
        r"\text{Re}(b + c)",
        r"whether `\text{Re}` is applied",
    ),
    (r"a = x[n]", "x[n]", "whether `x` is applied"),
    (r"a = x^2[0]", "x^2[0]", "whether `x^2` is applied"),
    (
        r"\vec L = \vec r \times m\vec p",
        r"\vec p",
        "products of vectors do not obey the rules of numbers",
    ),
    (
        r"\vec L = \vec r × \hat n",
        "×",
        r"`\times` between vectors does not commute",
    ),
    (
        r"W = \mathbf F \cdot \Delta\mathbf{r}_1",
        r"\Delta\mathbf{r}_1",
        "products of vectors do not obey",
    ),
    (
        r"W = \vec F(t) (a \boldsymbol{v} + b \bm{w})",
        r"(a \boldsymbol{v} + b \bm{w})",
        "products of vectors do not obey",
    ),
    (
        r"E = \frac12 m {\bf v}^2",
        r"{\bf v}^2",
        "powers and roots of vectors are not read",
    ),
    (
        r"E = (\vec v + \vec w)^2",
        r"(\vec v + \vec w)^2",
        "powers and roots of vectors are not read",
    ),
    (
        r"a = \sqrt{\vec v}",
        r"\sqrt{\vec v}",
        "powers and roots of vectors are not read",
    ),
    (
        r"F = |\vec F|",
        r"\vec F",
        "magnitudes of vectors are not read",
    ),
    (
        r"m = \vec F / \vec a",
        r"\vec a",
        "nothing is divided by a vector",
    ),
    (
        r"m = \frac{\vec F}{\vec a}",
        r"\frac{\vec F}{\vec a}",
        "nothing is divided by a vector",
    ),
    (
        r"a = \cos \vec k x",
        r"\cos \vec k x",
        "functions of vectors are not read",
    ),
    (
        r"\vec F = \frac{dU}{d\vec r}",
        r"\vec r",
        "this cannot be the variable of a differential",
    ),
    (
        r"C = \hat x\hat p - \hat p\hat x",
        r"\hat p",
        "what bears a hat may be an operator",
    ),
    (
        r"a = \cos \hat a \hat b",
        r"\hat b",
        "what bears a hat may be an operator",
    ),
    (
        r"a = \hat n \times \hat n",
        r"\times",
        r"`\times` between vectors does not commute",
    ),
    (r"v_\rm max = a", r"\rm", r"`\rm` switches the typeface"),
    (
        r"a = {\rm m a} b",
        "m",
        "TeX sets these letters as one word",
    ),
    (r"a = {\bf F r}", "F", "TeX sets these letters as one word"),
    (r"{\it KE} = a", "KE", "TeX sets these letters as one word"),
    (
        r"a = 5 {\rm kg\,x}",
        r"\rm kg\,x",
        r"`\rm{kg\,x}` is no name",
    ),
    (
        r"u^{(2)} = a",
        "(2)",
        "this may be an order, an index or a power",
    ),
    (
        r"a = x^{{[n+1]}} b",
        "{[n+1]}",
        "this may be an order, an index or a power",
    ),
    (
        r"a = (f g)^{\left( n \right)}",
        r"\left( n \right)",
        "this may be an order",
    ),
    (r"a = \sin^{(2)} x", "(2)", "this may be an order"),
    (
        r"a = f^{-1}(x)",
        "f^{-1}(x)",
        "this may be the inverse function of `f`",
    ),
    (
        r"a = {f^{-1}}\left(b + c\right)",
        r"{f^{-1}}\left(b + c\right)",
        "this may be the inverse function of `f`",
    ),
    (
        r"a = v_1^2(t)",
        "v_1^2(t)",
        "this may be a power of the value of a function `v_1`",
    ),
    (
        r"a = {v^2}(0)",
        "{v^2}(0)",
        "this may be a power of the value of a function `v`",
    ),
    (
        r"a = \qty{3}{J/kg K}",
        r"\qty{3}{J/kg K}",
        "what stands below the stroke",
    ),
    (
        r"a = \qty{3}{furlong}",
        r"\qty{3}{furlong}",
        "the unit `furlong` is not known",
    ),
    (
        r"a = \qty{3}{\kilo}",
        r"\qty{3}{\kilo}",
        r"a unit is missing after `\kilo`",
    ),
    (
        r"a = \qty{3(1)}{m}",
        r"\qty{3(1)}{m}",
        "`3(1)` is not read as a number",
    ),
    (
        r"a = \qty{3}{m^{9999999999}}",
        r"\qty{3}{m^{9999999999}}",
        "the power `9999999999` of a unit",
    ),
    (
        r"a = \qty{3}{m}^2",
        "^",
        "what this belongs to is not clear",
    ),
    (
        r"a = b/\qty{3}{m}",
        r"\qty{3}{m}",
        "whether this unit stands below the stroke",
    ),
    (
        r"a = 2\qty{3}{m}",
        r"\qty{3}{m}",
        "two numbers stand side by side",
    ),
    (
        r"\begin{aligned} a = b",
        r"\begin{aligned}",
        "the environment `aligned` is never ended",
    ),
    (
        r"a and b = c",
        "and",
        "the word `and` stands in the mathematics",
    ),
    (
        r"x = d\eta/d\mu",
        r"d\eta/d\mu",
        "this may be a derivative or a quotient",
    ),
    (r"x = -{a+b}", "{a+b}", "TeX does not print these braces"),
    (r"x = a / {b c}", "{b c}", "TeX does not print these braces"),
    (r"x = 10\,0000", "0000", "two numbers stand side by side"),
    (r"x = a \quad b", "b", "this is a term, not a statement"),
    (
        r"x = \sin^{-1} y",
        r"\sin^{-1}",
        "this may be the inverse function of `\\sin`",
    ),
    (r"x = \log_b y", "b", "a logarithm is read only with"),
    (
        r"x = f(a, 2)",
        "(a, 2)",
        "the arguments of an unknown function must be bare symbols",
    ),
    (
        r"x \overset{d}{=} 3",
        r"\overset",
        "only `?`, `!` and citations are read above",
    ),
    (
        r"\underline{a} = b",
        r"\underline{a}",
        "whether this line is part of the name",
    ),
    (
        r"a = 10{,}000",
        "10{,}000",
        "whether `10{,}000` has decimals",
    ),
    (r"a_-1 = b", "-", "this cannot be a subscript"),
    (
        r"a = \eqref{b}",
        r"\eqref{b}",
        "an equation is cited in the mathematics",
    ),
    (
        r"a = \ln \sin x \cos y",
        r"\cos",
        "where the argument of this function ends is not clear",
    ),
    (
        r"x = \sinh(\cosh y)",
        r"\cosh",
        "a hyperbolic function of another",
    ),
    (
        r"a = \theta^\circ",
        r"\circ",
        "degrees are read only right after a number",
    ),
    (
        r"a = \sin E^\circ",
        r"\circ",
        "degrees are read only right after a number",
    ),
    (
        r"T = 25\,^\circ\mathrm{C}",
        r"\circ",
        "temperatures on a scale of degrees",
    ),
    (r"f(A \mid B) = c", r"\mid", "`\\mid` is not read"),
    (
        r"c = \mathrm{H_x}",
        r"\mathrm{H_x}",
        "`\\mathrm{H_x}` is no name",
    ),
    (r"\boxed{a = b} c", "c", "`c` cannot stand here"),
    (r"x = 1, 2", "2", "this is a term, not a statement"),
    (
        r"a = b \tag{1} \tag{2}",
        r"\tag{2}",
        "an equation has one number",
    ),
];

#[test]
fn what_cannot_be_read_is_refused_at_its_place() {
    for (source, guilty, message) in REFUSALS {
        match read_display(source, whole(source)).statements {
            Ok(read) => panic!(
                "{source} was read as {:?}",
                read.iter().map(latex_statement).collect::<Vec<_>>()
            ),
            Err(error) => {
                assert_eq!(
                    source.get(error.span.range()),
                    Some(*guilty),
                    "{source}: {}",
                    error.message
                );
                assert!(
                    error.message.starts_with(message),
                    "{source}: {}",
                    error.message
                );
            }
        }
    }
}

#[test]
fn no_depth_or_length_exhausts_the_reader() {
    let (open, close) = [
        ("{", "}"),
        ("(", ")"),
        (r"\frac{1}{", "}"),
        (r"\binom{", "}{2}"),
        ("x^{", "}"),
        (r"\sin ", ""),
        (r"\sum_{i=1}^k ", ""),
        ("v_{", "}"),
        (r"\boxed{", "}"),
        (r"\sqrt", ""),
        ("a/", ""),
        (r"\Delta ", ""),
        (r"\dot", ""),
        ("|", "|"),
        ("-", ""),
        (r"\frac{d}{dx}", ""),
        (r"\int_0^1 ", "dx"),
        (r"\text{", "}"),
        ("f(", ")"),
        (r"\frac{d", "}{dx}"),
    ]
    .into_iter()
    .unzip::<_, _, Vec<_>, Vec<_>>();
    for (open, close) in open.into_iter().zip(close) {
        for count in [150, 10_000] {
            let source = format!("y = {}x{}", open.repeat(count), close.repeat(count));
            let read = read_display(&source, whole(&source)).statements;
            if let Ok(read) = read {
                let _ = read.iter().map(latex_statement).collect::<String>();
            }
        }
        let source = format!("y = {}x", open.repeat(10_000));
        assert!(
            read_display(&source, whole(&source)).statements.is_err(),
            "{open}"
        );
    }
    let long = format!("x = {}", "9".repeat(2_001));
    assert!(
        read_display(&long, whole(&long))
            .statements
            .unwrap_err()
            .message
            .contains("digits")
    );
}

fn number(n: i64, d: i64) -> Expr {
    Expr::Number(BigRational::new(n.into(), d.into()))
}

#[test]
fn a_slope_of_upright_names_reads_back() {
    let name = Expr::symbol(r"\text{KE}");
    let slope = Expr::Derivative {
        body: Expr::Product([name.clone(), name].into()).into(),
        variable: Symbol::new("x"),
    };
    let text = latex(&slope);
    assert_eq!(
        text,
        r"\frac{d}{dx} \left[ \text{KE} \cdot \text{KE} \right]"
    );
    assert_eq!(read_expr(&text, whole(&text)), Ok(slope));
}

fn name() -> impl Strategy<Value = Symbol> {
    prop::sample::select(vec![
        "a",
        "d",
        "e",
        "i",
        "v'_1",
        "E^*",
        r"\eta",
        r"\Delta",
        r"\Delta E_{\text{total}}",
        r"\dot{\delta}",
        r"\text{KE}",
        r"\text{erf}",
        r"\mathbb{P}",
        r"\rho_{\text{air}}",
        "v_{12}",
        r"\eta_{\max}",
        "E^*_1",
        "x''",
        r"x^\dagger",
        r"\text{d}",
        "f",
    ])
    .prop_map(Symbol::new)
}

fn bracketed() -> impl Strategy<Value = Symbol> {
    let names = [
        r"\langle x^2 \rangle",
        r"\langle v_1 \rangle_2",
        r"\text{E}[X]",
        r"\mathbb{E}[X^2]",
        r"\text{Cov}(X, Y)",
        r"P(X > 3)",
        r"\text{Pr}(A \mid B)",
        r"[\text{A}]_0",
        r"[\text{H}^+]",
    ];
    prop::sample::select(names.to_vec()).prop_map(Symbol::new)
}

fn variable() -> impl Strategy<Value = Symbol> {
    prop::sample::select(vec!["x", r"\mu", "t", "v'_1", r"\dot{\delta}"]).prop_map(Symbol::new)
}

/// Terms in the form in which the reader makes them.
fn term() -> impl Strategy<Value = Expr> {
    let leaf = prop_oneof![
        4 => name().prop_map(Expr::Symbol),
        1 => bracketed().prop_map(Expr::Symbol),
        2 => (0i64..200).prop_map(|n| number(n, 1)),
        1 => (1i64..50).prop_map(|n| number(n, 8)),
        1 => (name(), prop::collection::vec(name(), 1..3))
            .prop_map(|(f, all)| Expr::Apply(f, all.into_iter().map(Expr::Symbol).collect())),
    ];
    leaf.prop_recursive(5, 40, 4, |inner| {
        let shared = || inner.clone().prop_map(Arc::new);
        let function = prop::sample::select(vec![
            Function::Sin, Function::Cos, Function::Tan, Function::Exp, Function::Ln, Function::Abs,
            Function::Ceiling, Function::Floor,
        ]);
        let point = prop_oneof![
            Just(LimitPoint::PlusInfinity),
            Just(LimitPoint::MinusInfinity),
            shared().prop_map(LimitPoint::Finite),
        ];
        let element = || Expr::Element { sequence: Symbol::new("u'"), index: Symbol::new("j") };
        prop_oneof![
            3 => prop::collection::vec(inner.clone(), 2..5).prop_map(|all| Expr::Sum(all.into())),
            3 => prop::collection::vec(inner.clone(), 2..5).prop_map(|all| Expr::Product(all.into())),
            2 => shared().prop_map(Expr::Negate),
            2 => (shared(), shared()).prop_map(|(a, b)| Expr::Quotient(a, b)),
            2 => (shared(), shared()).prop_map(|(a, b)| Expr::Power(a, b)),
            1 => (shared(), 2i64..5).prop_map(|(a, n)| Expr::Power(a, number(1, n).into())),
            1 => (function, shared()).prop_map(|(f, a)| Expr::Call(f, a)),
            1 => (shared(), shared(), inner.clone()).prop_map(move |(from, to, body)| Expr::Series {
                index: Symbol::new("j"), from, to, body: Expr::Product([element(), body].into()).into(),
            }),
            1 => (shared(), shared(), shared()).prop_map(|(from, to, body)| Expr::Series {
                index: Symbol::new("j"), from, to, body,
            }),
            1 => (shared(), variable()).prop_map(|(body, variable)| Expr::Derivative { body, variable }),
            1 => (shared(), variable(), point).prop_map(|(body, variable, point)| Expr::Limit { body, variable, point }),
            1 => (shared(), variable(), shared(), shared())
                .prop_map(|(body, variable, from, to)| Expr::Integral { body, variable, from, to }),
        ]
    })
}

/// What such a term was shrunk to once.
#[test]
fn a_difference_in_an_exponent_is_no_factor() {
    let text = r"\Delta(a)^{\Delta E_{\text{total}}(a)}";
    let read = read_expr(text, whole(text)).expect("a power");
    assert!(matches!(&read, Expr::Power(base, _) if matches!(**base, Expr::Apply(..))));
    assert_eq!(latex(&read), text);
}

/// What such a term was shrunk to once.
#[test]
fn a_power_of_a_function_named_d_is_no_differential() {
    let of = Expr::Apply(
        Symbol::new("d"),
        vec![Expr::Symbol(Symbol::new(r"\dot{\delta}"))].into(),
    );
    let letter = |name| Arc::new(Expr::Symbol(Symbol::new(name)));
    let integral = Expr::Integral {
        body: letter("e"),
        variable: Symbol::new("x"),
        from: letter("e"),
        to: letter("a"),
    };
    let expr = Expr::Power(of.into(), integral.into());
    let text = latex(&expr);
    assert_eq!(text, r"d(\dot{\delta})^{\int_{e}^{a} e \, dx}");
    assert_eq!(read_expr(&text, whole(&text)).as_ref(), Ok(&expr));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 4000, ..ProptestConfig::default() })]

    #[test]
    fn what_is_printed_reads_back(expr in term()) {
        let text = latex(&expr);
        let read = read_expr(&text, whole(&text));
        prop_assert_eq!(read.as_ref().ok(), Some(&expr), "{} {:?}", text, read.as_ref().err());
        prop_assert!(!plain(&expr).is_empty());
    }

    #[test]
    fn what_is_read_prints_and_reads_back(pieces in prop::collection::vec(prop::sample::select(PIECES), 1..14)) {
        let source = pieces.concat();
        let display = read_display(&source, whole(&source));
        match display.statements {
            Ok(statements) => {
                let text = statements.iter().map(latex_statement).collect::<Vec<_>>().join(" ;; ");
                let again = printed(&text.replace(" ;; ", r" \qquad "));
                prop_assert_eq!(again.as_ref().ok(), Some(&text), "{} {:?}", source, again.as_ref().err());
            }
            Err(error) => prop_assert!(source.get(error.span.range()).is_some() && !error.message.is_empty()),
        }
    }

    #[test]
    fn no_text_makes_the_reader_panic(text in "(\\PC|[\\\\{}()_^&$='a-z0-9 ]){0,60}") {
        for end in 0..=text.len() {
            if let Err(error) = read_display(&text, Span::new(0, end)).statements {
                prop_assert!(error.span.end <= end.max(error.span.start));
            }
        }
    }
}

const PIECES: &[&str] = &[
    "a",
    "b_1",
    "v'_2",
    "^2",
    "^{n}",
    "^{-1}",
    "^{(n)}",
    "_1",
    "'",
    "+",
    "-",
    "=",
    r"\leq ",
    "2",
    "0.5",
    "(",
    ")",
    "{",
    "}",
    "|",
    "/",
    r"\cdot ",
    r"\times ",
    r"\frac{a}{b}",
    r"\frac12",
    r"\binom{n}{2}",
    "3!",
    r"\sqrt{x}",
    r"{\rm ab}",
    r"\mathrm{Var}",
    r"\vec a ",
    r"\hat b ",
    "[",
    "]",
    r"\rm ",
    r"{\bf F}",
    r"\sin ",
    r"\Delta ",
    "d",
    "x",
    r"\int_0^1 ",
    r"\sum_{i=1}^k ",
    "u_i",
    r"\cdots ",
    "u_1",
    "u_k",
    r"\frac{d}{dx}",
    r"\lim_{x \to 0}",
    r"\boxed{",
    "a=b",
    ",",
    r"\quad ",
    r"\Rightarrow ",
    r"\checkmark ",
    r"P(t)",
    r"\left(",
    r"\right)",
    r"E^*",
    r"\text{and}",
    r"\\",
    "&",
];

#[test]
fn time_is_linear_in_length() {
    let pieces = [
        "a + ",
        "a b ",
        "u_1 + ",
        r"\text{ ",
        r"\boxed{a = ",
        r"\frac{d",
        r"\times \quad ",
        r"\\ & ",
        "{",
        r"\begin{aligned} ",
    ];
    for piece in pieces {
        let source = format!("x = {}", piece.repeat(100_000));
        let start = std::time::Instant::now();
        let _ = read_display(&source, whole(&source));
        // What grew with the square of the length would take far longer, and a busy machine far less.
        assert!(start.elapsed().as_secs() < 60, "{piece}");
    }
}

#[test]
fn names_on_a_terminal() {
    for (name, shown) in [
        ("v'_1", "v′₁"),
        ("\\Delta E_{\\text{total}}", "ΔE_{total}"),
        ("\\dot{\\delta}", "δ\u{307}"),
        ("E^*", "E*"),
        ("E^{\\text{kin}}_0", "E^kin₀"),
        ("\\eta_{\\max}", "η_{max}"),
        ("v_{12}", "v₁₂"),
    ] {
        assert_eq!(plain(&Expr::Symbol(Symbol::new(name))), shown);
    }
}

/// What the text calls a function is none of the factors: `f(x + 1)` beside "Let $f(x) = x^2$" is refused, and was a product.
#[test]
fn functions_of_the_text_are_no_factors() {
    let page = |words: &str| {
        last(&format!(
            "{words}\n\n$$ y = f(x + 1). \\tag{{1}} $$\n\nHence by (1)\n\n$$ y = f x + f. \\tag{{2}} $$\n"
        ))
    };
    for words in [
        "Let $f(x) = x^2$. Then",
        "The function $f$ is shifted,",
        "Here $f(t)$ is the force,",
    ] {
        assert_eq!(page(words), "undecided", "{words}");
    }
    assert_eq!(page("With the factor $f$,"), "holds");
}
