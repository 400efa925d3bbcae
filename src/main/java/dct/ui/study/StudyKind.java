package dct.ui.study;

import dct.experiment.generate.PolygonShape;
import dct.experiment.generate.RegionShape;
import dct.experiment.generate.SiteShape;
import dct.experiment.study.AnnuliStudy;
import dct.experiment.study.PointsStudy;
import dct.experiment.study.PolygonsStudy;
import dct.experiment.study.Study;
import dct.experiment.study.StudyPlan;
import dct.experiment.study.ThesisTable;
import java.util.List;
import java.util.Map;

/** The studies, and what they try unless asked otherwise. */
public enum StudyKind {
  /** The thesis's experiment on sites. */
  POINTS(
      "Point Sites",
      "Table 4.4 again: many sets of sites, and how many of them become even",
      "50-500:50",
      ThesisTable.SETS,
      SiteShape.MOST),
  /** The experiment on polygons. */
  POLYGONS(
      "Polygons",
      "Many random polygons, and how many of their vertices become even",
      "10,20,50,100,200",
      20,
      PolygonShape.MOST),
  /** The experiment on annuli and other regions. */
  ANNULI(
      "Regions with Holes",
      "Many random regions with holes, annuli first, and how many of their vertices become even",
      "50,100,200",
      10,
      PolygonShape.MOST);

  private final String title;
  private final String description;
  private final String sizes;
  private final int sets;
  private final int most;

  StudyKind(String title, String description, String sizes, int sets, int most) {
    this.title = title;
    this.description = description;
    this.sizes = sizes;
    this.sets = sets;
    this.most = most;
  }

  /** Its name in the menu. */
  public String title() {
    return title;
  }

  /** A sentence for the tooltip. */
  public String description() {
    return description;
  }

  /** The words of the shapes that there are. */
  List<String> shapes() {
    return switch (this) {
      case POINTS -> SiteShape.words();
      case POLYGONS -> PolygonShape.words();
      case ANNULI -> RegionShape.words();
    };
  }

  /** The words of the shapes that are chosen at first. */
  List<String> usualShapes() {
    return this == POINTS ? List.of(ThesisTable.SHAPE) : shapes();
  }

  /** The sizes at first, as a user would list them. */
  String sizes() {
    return sizes;
  }

  /** The number of sets at first. */
  int sets() {
    return sets;
  }

  /** The largest size. */
  int most() {
    return most;
  }

  /** The study of this plan. */
  Study study(StudyPlan plan) {
    return switch (this) {
      case POINTS -> new PointsStudy(plan);
      case POLYGONS -> new PolygonsStudy(plan, Map.of());
      case ANNULI -> new AnnuliStudy(plan);
    };
  }
}
