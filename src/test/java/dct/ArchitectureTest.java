package dct;

import static com.tngtech.archunit.core.domain.JavaCall.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.simpleNameEndingWith;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.type;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameMatching;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.Architectures.layeredArchitecture;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SliceAssignment;
import com.tngtech.archunit.library.dependencies.SliceIdentifier;
import java.io.InputStream;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.text.Format;
import java.util.Formatter;
import java.util.Scanner;

/** The layers of docs/architecture.md, and what each package may use. */
@AnalyzeClasses(packages = "dct", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {

  @ArchTest
  static final ArchRule ARROWS_POINT_DOWN =
      layeredArchitecture()
          .consideringOnlyDependenciesInLayers()
          .withOptionalLayers(true)
          .layer("main")
          .definedBy("dct")
          .layer("ui")
          .definedBy("dct.ui..")
          .layer("cli")
          .definedBy("dct.cli..")
          .layer("experiment")
          .definedBy("dct.experiment..")
          .layer("render")
          .definedBy("dct.render..")
          .layer("io")
          .definedBy("dct.io..")
          .layer("problem")
          .definedBy("dct.problem..")
          .layer("core")
          .definedBy("dct.core..")
          .whereLayer("main")
          .mayOnlyAccessLayers("ui", "cli")
          .whereLayer("ui")
          .mayOnlyAccessLayers("experiment", "render", "io", "problem", "core")
          .whereLayer("cli")
          .mayOnlyAccessLayers("experiment", "render", "io", "problem", "core")
          .whereLayer("experiment")
          .mayOnlyAccessLayers("render", "io", "problem", "core")
          .whereLayer("render")
          .mayOnlyAccessLayers("io", "problem", "core")
          .whereLayer("io")
          .mayOnlyAccessLayers("problem", "core")
          .whereLayer("problem")
          .mayOnlyAccessLayers("core")
          .whereLayer("core")
          .mayNotAccessAnyLayer();

  @ArchTest
  static final ArchRule CORE_POINTS_DOWN =
      layeredArchitecture()
          .consideringOnlyDependenciesInLayers()
          .layer("degree")
          .definedBy("dct.core.degree..")
          .layer("triangulate")
          .definedBy("dct.core.triangulate..")
          .layer("dcel")
          .definedBy("dct.core.dcel..")
          .layer("geometry")
          .definedBy("dct.core.geometry..")
          .whereLayer("triangulate")
          .mayOnlyAccessLayers("dcel", "geometry")
          .whereLayer("dcel")
          .mayOnlyAccessLayers("geometry")
          .whereLayer("geometry")
          .mayNotAccessAnyLayer();

  @ArchTest
  static final ArchRule PACKAGES_BELOW_THE_WINDOW_DO_NOT_USE_IT =
      noClasses()
          .that()
          .resideInAPackage("dct.ui.*..")
          .should()
          .dependOnClassesThat()
          .resideInAPackage("dct.ui");

  @ArchTest
  static final ArchRule PACKAGES_FORM_NO_CYCLE =
      slices().matching("dct.(**)").should().beFreeOfCycles();

  @ArchTest
  static final ArchRule CLASSES_FORM_NO_CYCLE =
      slices().assignedFrom(new ByFile()).should().beFreeOfCycles();

  /** A class with everything nested in it. */
  private static final class ByFile implements SliceAssignment {
    @Override
    public SliceIdentifier getIdentifierOf(JavaClass type) {
      JavaClass outermost = type.getBaseComponentType();
      while (outermost.getEnclosingClass().isPresent()) {
        outermost = outermost.getEnclosingClass().get();
      }
      return outermost.getPackageName().startsWith("dct")
          ? SliceIdentifier.of(outermost.getName())
          : SliceIdentifier.ignore();
    }

    @Override
    public String getDescription() {
      return "classes, each with those nested in it";
    }
  }

  @ArchTest
  static final ArchRule NO_SCREEN_BELOW_THE_PICTURES =
      noClasses()
          .that()
          .resideInAnyPackage("dct.core..", "dct.problem..", "dct.io..", "dct.experiment..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("java.awt..", "javax.swing..", "com.formdev..");

  @ArchTest
  static final ArchRule PICTURES_NEED_NO_WINDOW =
      noClasses()
          .that()
          .resideInAPackage("dct.render..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("javax.swing..", "com.formdev..");

  @ArchTest
  static final ArchRule THE_CORE_READS_AND_PRINTS_NOTHING =
      noClasses()
          .that()
          .resideInAnyPackage("dct.core..", "dct.problem..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage("java.io..", "java.nio..", "java.net..");

  @ArchTest
  static final ArchRule TOOLS_KNOW_NO_COMPONENT =
      noClasses()
          .that()
          .resideInAnyPackage("dct.ui.tool..", "dct.ui.document..")
          .should()
          .dependOnClassesThat()
          .resideInAnyPackage(
              "javax.swing..",
              "dct.ui",
              "dct.ui.canvas..",
              "dct.ui.command..",
              "dct.ui.dialog..",
              "dct.ui.edit..",
              "dct.ui.file..",
              "dct.ui.solve..",
              "dct.ui.workbench..");

  @ArchTest
  static final ArchRule ONLY_THE_COMMAND_LINE_PRINTS =
      noClasses()
          .that()
          .resideOutsideOfPackage("dct.cli..")
          .and()
          .doNotHaveFullyQualifiedName("dct.Main")
          .should()
          .accessField(System.class, "out")
          .orShould()
          .accessField(System.class, "err");

  @ArchTest
  static final ArchRule ONE_RANDOM_SOURCE_ALIKE_ON_EVERY_JDK =
      noClasses()
          .that()
          .resideInAnyPackage("dct.core..", "dct.experiment.generate..")
          .should()
          .dependOnClassesThat(
              resideInAPackage("java.util.random..")
                  .or(simpleNameEndingWith("Random").and(resideInAPackage("java.."))));

  /** The last bits of {@link Math}'s functions are left to each JDK; StrictMath's are not. */
  @ArchTest
  static final ArchRule NO_FUNCTION_WITH_LAST_BITS_OF_ITS_OWN =
      noClasses()
          .that()
          .resideInAnyPackage("dct.core..", "dct.experiment.generate..")
          .should()
          .callMethodWhere(
              target(owner(type(Math.class)))
                  .and(
                      target(
                          nameMatching(
                              "a?(sin|cos|tan)h?|atan2|log|log10|log1p|exp|expm1|pow|cbrt|hypot"
                                  + "|random"))));

  /** Digits, letters and points of the machine's locale must not reach a file or a message. */
  @ArchTest
  static final ArchRule FORMATS_NAME_THEIR_LOCALE =
      noClasses()
          .should()
          .callMethod(String.class, "formatted", Object[].class)
          .orShould()
          .callMethod(String.class, "format", String.class, Object[].class)
          .orShould()
          .callMethod(String.class, "toLowerCase")
          .orShould()
          .callMethod(String.class, "toUpperCase")
          .orShould()
          .callMethod(PrintStream.class, "printf", String.class, Object[].class)
          .orShould()
          .callMethod(PrintStream.class, "format", String.class, Object[].class)
          .orShould()
          .callMethod(PrintWriter.class, "printf", String.class, Object[].class)
          .orShould()
          .callMethod(PrintWriter.class, "format", String.class, Object[].class)
          .orShould()
          .callConstructor(Formatter.class)
          .orShould()
          .callConstructor(Scanner.class, InputStream.class)
          .orShould()
          .dependOnClassesThat()
          .areAssignableTo(Format.class)
          .orShould()
          .dependOnClassesThat()
          .resideInAPackage("java.time.format..");
}
